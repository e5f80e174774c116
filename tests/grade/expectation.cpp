#include "tests/grade/expectation.h"

#include <toml++/toml.h>
#include <set>
#include <stdexcept>

namespace meshgrade {
namespace {

const std::map<std::string, std::uint32_t Limits::*> kLimits{
    {"case_cpu_ms", &Limits::case_cpu_ms},
    {"case_wall_ms", &Limits::case_wall_ms},
    {"run_seconds", &Limits::run_seconds},
    {"memory_mb", &Limits::memory_mb}};

void refuse_unknown_keys(const toml::table& table, const std::set<std::string>& known) {
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    if (known.count(name) == 0) throw std::runtime_error("expected.toml: unknown key " + name);
  }
}

}  // namespace

Expectation read_expectation(const std::filesystem::path& folder) {
  Expectation expected;
  const std::filesystem::path file = folder / "expected.toml";
  if (!std::filesystem::exists(file)) return expected;
  const toml::table table = toml::parse_file(file.string());
  refuse_unknown_keys(table, {"verdict", "rule", "points", "extra_points", "says", "others",
                              "alone", "limits", "probably", "options"});
  expected.verdict = table["verdict"].value_or(expected.verdict);
  expected.rule = table["rule"].value_or(expected.rule);
  expected.points = table["points"].value<double>();
  if (const toml::array* range = table["points"].as_array()) {
    expected.points = range->at(0).value<double>();
    expected.most_points = range->at(1).value<double>();
  }
  expected.extra_points = table["extra_points"].value<double>();
  expected.alone = table["alone"].value_or(false);
  if (const toml::array* says = table["says"].as_array()) {
    for (const toml::node& text : *says)
      expected.says.push_back(text.value<std::string>().value());
  }
  if (const toml::array* names = table["probably"].as_array()) {
    for (const toml::node& name : *names)
      expected.probably.insert(name.value<std::string>().value());
  }
  if (const toml::table* options = table["options"].as_table()) {
    for (const auto& [name, value] : *options)
      expected.options[std::string(name.str())] = value.value<std::string>().value();
  }
  if (const toml::table* others = table["others"].as_table()) {
    for (const auto& [exercise, verdict] : *others)
      expected.others[std::string(exercise.str())] = verdict.value<std::string>().value();
  }
  if (const toml::table* limits = table["limits"].as_table()) {
    for (const auto& [name, value] : *limits) {
      const auto limit = kLimits.find(std::string(name.str()));
      if (limit == kLimits.end()) throw std::runtime_error("expected.toml: unknown limit");
      expected.limits.emplace_back(limit->second, value.value<std::uint32_t>().value());
    }
  }
  return expected;
}

}  // namespace meshgrade
