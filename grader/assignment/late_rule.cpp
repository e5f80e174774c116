#include "grader/assignment/late_rule.h"

#include <chrono>

#include "grader/assignment/toml_section.h"
#include "grader/base/pattern.h"
#include "grader/base/safe_file.h"

namespace meshgrade {
namespace {

namespace chrono = std::chrono;

/// Empty if there is no such day.
std::optional<std::int64_t> seconds_of_day(int year, int month, int day) {
  const chrono::year_month_day date{chrono::year(year),
                                    chrono::month(static_cast<unsigned>(month)),
                                    chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  return std::int64_t{86'400} * chrono::sys_days(date).time_since_epoch().count();
}

LateRule read_rule(TomlSection section) {
  LateRule rule;
  const toml::date_time due = section.require_moment("due");
  rule.zone = std::int64_t{60} * due.offset->minutes;
  rule.due = seconds_of_day(due.date.year, due.date.month, due.date.day).value_or(0) +
             3600 * due.time.hour + 60 * due.time.minute + due.time.second - rule.zone;
  const double grace = section.get("grace_minutes", 0.0);
  if (!(grace >= 0.0 && grace <= 1e6)) {
    section.fail_at("grace_minutes", "must be a number from 0 to 1000000");
  }
  rule.grace = static_cast<std::int64_t>(60.0 * grace);
  rule.per_day = section.require_points_or_share("per_day");
  if (section.has("at_most")) rule.at_most = section.require_points_or_share("at_most");
  section.refuse_unknown_keys();
  return rule;
}

/// "-0800", "-08:00", "Z", "UTC"
std::int64_t zone_of(const std::string& text) {
  if (text[0] != '+' && text[0] != '-') return 0;
  const std::int64_t hours = std::stoi(text.substr(1, 2));
  const std::int64_t minutes = std::stoi(text.substr(text.size() - 2));
  return (text[0] == '-' ? -60 : 60) * (60 * hours + minutes);
}

}  // namespace

std::optional<LateRule> parse_late_rule(const std::string& text, const std::string& name) {
  try {
    const toml::table table = toml::parse(text, name);
    if (!table.contains("late")) return std::nullopt;
    return read_rule(TomlSection(table, name, "").section("late"));
  } catch (const toml::parse_error& error) {
    throw UserError(name + ":" + std::to_string(error.source().begin.line) + ": " +
                    std::string(error.description()));
  }
}

std::optional<LateRule> read_late_rule(const std::filesystem::path& file) {
  return parse_late_rule(read_whole_file(file), file.string());
}

std::optional<std::int64_t> read_moment(const std::string& text, std::int64_t zone) {
  static const Pattern form(
      "\\s*([0-9]{4})-([0-9]{2})-([0-9]{2})[T "
      "]([0-9]{2}):([0-9]{2})(?::([0-9]{2})(?:[.,][0-9]+)"
      "?)?\\s*(Z|UTC|GMT|[+-][0-9]{2}:?[0-9]{2})?\\s*");
  Pattern::Groups found;
  if (text.size() > 100 || !form.matches(text, found)) return std::nullopt;
  const auto number = [&](std::size_t i) {
    return !found[i].empty() ? std::stoi(found[i]) : 0;
  };
  const auto day = seconds_of_day(number(1), number(2), number(3));
  if (!day || number(4) > 23 || number(5) > 59 || number(6) > 60) return std::nullopt;
  const std::int64_t east = !found[7].empty() ? zone_of(found[7]) : zone;
  return *day + 3600 * number(4) + 60 * number(5) + number(6) - east;
}

}  // namespace meshgrade
