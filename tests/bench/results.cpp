#include "tests/bench/results.h"

#include <array>
#include <cstdio>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

namespace meshgrade::bench {
namespace {

/// Three significant digits, without exponents.
std::string short_number(double value) {
  const int digits = value >= 100 ? 0 : (value >= 10 ? 1 : 2);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

double ratio(const Samples& a, const Samples& b) {
  return a.size() == b.size() ? median_ratio(a, b) : median(a) / median(b);
}

std::string cell_text(const Table& table, const Row& row, std::size_t column) {
  const Samples& samples = row.cells[column];
  if (samples.empty()) return "-";
  const Samples* base = table.find(table.base, table.columns[column]);
  std::string text = short_number(median(samples));
  if (base != nullptr) text += " (" + short_number(ratio(samples, *base)) + ")";
  return text;
}

}  // namespace

Row& Table::row(const std::string& row_name) {
  for (Row& row : rows) {
    if (row.name == row_name) return row;
  }
  return rows.emplace_back(Row{row_name, {}});
}

const Samples* Table::find(const std::string& row_name, const std::string& column) const {
  for (const Row& row : rows) {
    if (row.name != row_name) continue;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (columns[i] == column) return &row.cells[i];
    }
  }
  return nullptr;
}

std::optional<GoalResult> evaluate(const Goal& goal, const std::vector<Table>& tables) {
  for (const Table& table : tables) {
    if (table.name != goal.table) continue;
    const bool other_column = !goal.base_column.empty();
    const Samples* cell = table.find(goal.row, goal.column);
    const Samples* base = table.find(goal.base, other_column ? goal.base_column : goal.column);
    if (cell == nullptr || base == nullptr) return std::nullopt;
    const bool at_most = goal.sense == Goal::kAtMost;
    GoalResult result;
    result.text = goal.table + ", " + goal.column + ": " + goal.row + " at " +
                  (at_most ? "most " : "least ") + short_number(goal.bound) +
                  (at_most ? " times " : " times faster than ") + goal.base +
                  (other_column ? " at " + goal.base_column : "");
    result.value = at_most ? ratio(*cell, *base) : ratio(*base, *cell);
    result.met = at_most ? result.value <= goal.bound : result.value >= goal.bound;
    return result;
  }
  return std::nullopt;
}

void print(std::ostream& out, const Table& table) {
  constexpr int kNameWidth = 32;
  constexpr int kCellWidth = 18;
  out << "\n" << table.title << " (ratio to " << table.base << ")\n";
  out << std::left << std::setw(kNameWidth) << "" << std::right;
  for (const std::string& column : table.columns)
    out << std::setw(kCellWidth) << column;
  out << "\n";
  for (const Row& row : table.rows) {
    out << std::left << std::setw(kNameWidth) << row.name << std::right;
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      out << std::setw(kCellWidth) << cell_text(table, row, i);
    out << "\n";
  }
}

void print(std::ostream& out, const std::vector<GoalResult>& goals) {
  out << "\ngoals\n";
  for (const GoalResult& goal : goals) {
    out << (goal.met ? "  met     " : "  missed  ") << std::setw(6) << short_number(goal.value)
        << "  " << goal.text << "\n";
  }
}

nlohmann::json to_json(const Results& results) {
  nlohmann::json json{{"tables", nlohmann::json::array()}, {"goals", nlohmann::json::array()}};
  for (const Table& table : results.tables) {
    nlohmann::json rows = nlohmann::json::array();
    for (const Row& row : table.rows) {
      nlohmann::json medians = nlohmann::json::array();
      for (const Samples& samples : row.cells)
        medians.push_back(median(samples));
      rows.push_back({{"name", row.name}, {"medians", medians}, {"samples", row.cells}});
    }
    json["tables"].push_back({{"name", table.name},
                              {"title", table.title},
                              {"base", table.base},
                              {"columns", table.columns},
                              {"rows", rows}});
  }
  for (const GoalResult& goal : results.goals) {
    json["goals"].push_back({{"text", goal.text}, {"value", goal.value}, {"met", goal.met}});
  }
  return json;
}

}  // namespace meshgrade::bench
