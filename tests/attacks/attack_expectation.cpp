#include "tests/attacks/attack_expectation.h"

#include <toml++/toml.h>
#include <map>
#include <set>
#include <stdexcept>

namespace meshgrade {
namespace {

const std::map<std::string, std::uint32_t Limits::*> kLimits{
    {"compile_seconds", &Limits::compile_seconds},
    {"compile_memory_mb", &Limits::compile_memory_mb},
    {"object_mb", &Limits::object_mb},
    {"output_mb", &Limits::output_mb},
    {"run_seconds", &Limits::run_seconds}};

std::vector<std::string> texts(const toml::table& table, const char* key) {
  std::vector<std::string> found;
  if (const toml::array* list = table[key].as_array()) {
    for (const toml::node& text : *list)
      found.push_back(text.value<std::string>().value());
  }
  return found;
}

}  // namespace

AttackExpectation read_attack(const std::filesystem::path& folder, const Limits& limits) {
  const toml::table table = toml::parse_file((folder / "expected.toml").string());
  const std::set<std::string> known{"verdict", "points",         "says",  "hides",
                                    "layers",  "needs_landlock", "limits"};
  for (const auto& [key, node] : table) {
    if (known.count(std::string(key.str())) == 0) {
      throw std::runtime_error("expected.toml: unknown key " + std::string(key.str()));
    }
  }
  AttackExpectation expected;
  expected.verdicts = texts(table, "verdict");
  if (expected.verdicts.empty())
    expected.verdicts = {table["verdict"].value<std::string>().value()};
  expected.points = table["points"].value<double>().value();
  expected.says = texts(table, "says");
  expected.hides = texts(table, "hides");
  expected.needs_landlock = table["needs_landlock"].value_or(0);
  if (const toml::array* layers = table["layers"].as_array()) {
    expected.layers.clear();
    for (const toml::node& layer : *layers)
      expected.layers.push_back(layer.value<int>().value());
  }
  expected.limits = limits;
  if (const toml::table* own = table["limits"].as_table()) {
    for (const auto& [key, value] : *own)
      expected.limits.*kLimits.at(std::string(key.str())) =
          value.value<std::uint32_t>().value();
  }
  return expected;
}

}  // namespace meshgrade
