#include "grader/mutants/survivor_list.h"

#include <toml++/toml.h>

#include <sstream>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const toml::source_region& place,
                         const std::string& what) {
  throw UserError(file.string() + ":" + std::to_string(place.begin.line) + ": " + what);
}

void add_group(const std::filesystem::path& file, const toml::node& node, SurvivorList& list) {
  const toml::table* group = node.as_table();
  const auto reason = group == nullptr ? std::nullopt : (*group)["reason"].value<std::string>();
  const toml::array* mutants = group == nullptr ? nullptr : (*group)["mutants"].as_array();
  if (!reason || mutants == nullptr) {
    refuse(file, node.source(), "a group has a `reason` and a list `mutants`");
  }
  for (const toml::node& mutant : *mutants) {
    const auto id = mutant.value<std::string>();
    if (!id) refuse(file, mutant.source(), "a mutant is named by a string");
    if (!list.emplace(*id, *reason).second) refuse(file, mutant.source(), "listed twice");
  }
}

}  // namespace

SurvivorList read_survivor_list(const std::filesystem::path& file) {
  SurvivorList list;
  try {
    const toml::table root = toml::parse_file(file.string());
    const toml::array* groups = root["group"].as_array();
    if (groups == nullptr) return list;
    for (const toml::node& group : *groups)
      add_group(file, group, list);
  } catch (const toml::parse_error& error) {
    refuse(file, error.source(), std::string(error.description()));
  }
  return list;
}

}  // namespace meshgrade
