#pragma once

// Reads tables of TOML files that people write: what is wrong is told with file, line and key.

#include <toml++/toml.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/assignment/late_rule.h"
#include "grader/base/errors.h"
#include "grader/base/text.h"

namespace meshgrade {

/// A table of the file. Every key that is asked for is remembered, so that the others can be
/// refused at the end.
class TomlSection {
 public:
  TomlSection(const toml::table& table, std::string file, std::string path)
      : table_(table), file_(std::move(file)), path_(std::move(path)) {}

  template <class T>
  T get(const std::string& key, T standard) {
    known_.insert(key);
    const toml::node* node = table_.get(key);
    return node == nullptr ? standard : convert<T>(*node, key);
  }

  template <class T>
  T require(const std::string& key) {
    known_.insert(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) fail(table_, "the key " + full(key) + " is missing");
    return convert<T>(*node, key);
  }

  double require_at_least(const std::string& key, double least) {
    const double value = require<double>(key);
    if (!(value >= least) || !std::isfinite(value)) {
      fail(*table_.get(key), full(key) + " must be a number of at least " +
                                 std::to_string(static_cast<int>(least)));
    }
    return value;
  }

  /// A positive whole number.
  std::uint32_t get_positive(const std::string& key, std::uint32_t standard) {
    const auto value = get<std::int64_t>(key, standard);
    if (value < 1 || value > 1'000'000'000) {
      fail(*table_.get(key), full(key) + " must be a whole number from 1 to 1000000000");
    }
    return static_cast<std::uint32_t>(value);
  }

  /// One of these words; the first, if the key is not there.
  template <class T>
  T get_choice(const std::string& key, const std::vector<std::pair<std::string, T>>& choices) {
    known_.insert(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) return choices.at(0).second;
    std::vector<std::string> words;
    for (const auto& [name, value] : choices) {
      if (node->value<std::string>() == name) return value;
      words.push_back("\"" + name + "\"");
    }
    fail(*node, full(key) + " must be one of " + join(words, ", "));
  }

  /// A number of points, or a share of the full points in per cent: 5 or "10 %".
  PointsOrShare require_points_or_share(const std::string& key) {
    known_.insert(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) fail(table_, "the key " + full(key) + " is missing");
    static const std::regex per_cent("([0-9]{1,3}(?:[.][0-9]{1,6})?) ?%");
    std::smatch found;
    const std::string text = node->value<std::string>().value_or("");
    const bool is_share = std::regex_match(text, found, per_cent);
    const double value =
        is_share ? std::stod(found[1]) / 100.0 : node->value<double>().value_or(-1.0);
    const bool is_number = is_share || node->is_number();
    if (!is_number || !(value >= 0.0) || !std::isfinite(value) || (is_share && value > 1.0)) {
      fail(*node, full(key) +
                      " must be a number of points, such as 5, or a part of the full "
                      "points, such as \"10 %\"");
    }
    return {value, is_share};
  }

  /// A moment with its zone.
  toml::date_time require_moment(const std::string& key) {
    known_.insert(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) fail(table_, "the key " + full(key) + " is missing");
    const auto moment = node->value<toml::date_time>();
    if (!moment || !moment->offset) {
      fail(*node, full(key) +
                      " must be a time with its zone and without quotes, such as "
                      "2026-03-01T23:59:00-08:00");
    }
    return *moment;
  }

  bool has(const std::string& key) const { return table_.contains(key); }
  bool is_text(const std::string& key) const {
    const toml::node* node = table_.get(key);
    return node != nullptr && node->is_string();
  }

  /// [[0, 1], [4, 2]]: at least one pair of whole numbers, none below 0.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> require_pairs(const std::string& key) {
    known_.insert(key);
    const toml::node* node = table_.get(key);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    const toml::array* list = node == nullptr ? nullptr : node->as_array();
    const auto number = [](const toml::node& entry) {
      const auto value = entry.value_exact<std::int64_t>();
      return value && *value >= 0 && *value < 1'000'000'000 ? *value : -1;
    };
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
      const toml::array* pair = (*list)[i].as_array();
      if (pair == nullptr || pair->size() != 2 || number((*pair)[0]) < 0 ||
          number((*pair)[1]) < 0) {
        fail((*list)[i],
             full(key) + " must be a list of pairs of vertices, as [[0, 1], [4, 2]]");
      }
      pairs.emplace_back(number((*pair)[0]), number((*pair)[1]));
    }
    if (pairs.empty()) {
      fail(node == nullptr ? table_ : *node,
           full(key) + " must be a list of pairs of vertices, as [[0, 1], [4, 2]]");
    }
    return pairs;
  }

  std::vector<std::string> get_strings(const std::string& key) {
    known_.insert(key);
    std::vector<std::string> values;
    const toml::node* node = table_.get(key);
    if (node == nullptr) return values;
    if (!node->is_array()) fail(*node, full(key) + " must be a list of names");
    for (const toml::node& entry : *node->as_array()) {
      values.push_back(convert<std::string>(entry, key));
    }
    return values;
  }

  /// The sub-table under this key; an empty one if there is none.
  TomlSection section(const std::string& key) {
    known_.insert(key);
    static const toml::table empty;
    const toml::node* node = table_.get(key);
    if (node != nullptr && !node->is_table()) fail(*node, full(key) + " must be a table");
    return {node == nullptr ? empty : *node->as_table(), file_, full(key)};
  }

  std::vector<TomlSection> sections(const std::string& key) {
    known_.insert(key);
    std::vector<TomlSection> result;
    const toml::node* node = table_.get(key);
    if (node == nullptr || !node->is_array_of_tables()) {
      fail(node == nullptr ? table_ : *node, "at least one [[" + full(key) + "]] is needed");
    }
    for (const toml::node& entry : *node->as_array()) {
      result.emplace_back(*entry.as_table(), file_, full(key));
    }
    return result;
  }

  /// The same, or none at all.
  std::vector<TomlSection> sections_if_any(const std::string& key) {
    known_.insert(key);
    return table_.contains(key) ? sections(key) : std::vector<TomlSection>();
  }

  /// All keys of this table with their values, which must be texts.
  std::map<std::string, Option> all_options() {
    std::map<std::string, Option> options;
    for (const auto& [key, node] : table_) {
      const std::string name(key.str());
      options[name] = {require<std::string>(name), place_of(node)};
    }
    return options;
  }

  /// Where the table begins.
  std::string place() const { return place_of(table_); }

  void refuse_unknown_keys() const {
    for (const auto& [key, node] : table_) {
      const std::string name(key.str());
      if (known_.count(name) == 0) fail(node, "unknown key " + full(name));
    }
  }

  [[noreturn]] void fail_at(const std::string& key, const std::string& what) const {
    const toml::node* node = table_.get(key);
    fail(node == nullptr ? table_ : *node, full(key) + " " + what);
  }

 private:
  /// "assignment.toml:42"
  std::string place_of(const toml::node& node) const {
    return file_ + ":" + std::to_string(node.source().begin.line);
  }

  std::string full(const std::string& key) const {
    return path_.empty() ? key : path_ + "." + key;
  }

  [[noreturn]] void fail(const toml::node& node, const std::string& what) const {
    throw UserError(place_of(node) + ": " + what);
  }

  template <class T>
  T convert(const toml::node& node, const std::string& key) const {
    const auto value = node.value<T>();
    constexpr bool is_text = std::is_same_v<T, std::string>;
    constexpr bool is_flag = std::is_same_v<T, bool>;
    constexpr bool is_whole = std::is_same_v<T, std::int64_t>;
    if (!value || (is_text && !node.is_string()) || (is_flag && !node.is_boolean()) ||
        (is_whole && !node.is_integer())) {
      fail(node, full(key) + " must be " +
                     (is_text    ? "a text in quotes"
                      : is_flag  ? "true or false"
                      : is_whole ? "a whole number"
                                 : "a number"));
    }
    return *value;
  }

  const toml::table& table_;
  std::string file_;
  std::string path_;
  std::set<std::string> known_;
};

}  // namespace meshgrade
