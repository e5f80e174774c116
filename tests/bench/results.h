#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace meshgrade::bench {

/// One row of a table; no samples where there is nothing to measure.
struct Row {
  std::string name;
  std::vector<Samples> cells;  ///< one for each column
};

struct Table {
  std::string name;                  ///< a key, such as "loop"
  std::string title;                 ///< what is measured, and in which unit
  std::string base;                  ///< the row that the others are compared with
  std::vector<std::string> columns;  ///< the meshes, mostly
  std::vector<Row> rows;

  Row& row(const std::string& row_name);
  /// nullptr if it was not measured
  const Samples* find(const std::string& row_name, const std::string& column) const;
};

/// A bound on the ratio of two cells of one table.
struct Goal {
  std::string table;
  std::string row;
  std::string base;
  std::string column;
  double bound;
  enum { kAtMost, kAtLeast } sense = kAtMost;  ///< of row / base, or of base / row
  std::string base_column{};                   ///< if another one than `column`
};

struct GoalResult {
  std::string text;
  double value = 0.0;
  bool met = false;
};

struct Results {
  std::vector<Table> tables;
  std::vector<GoalResult> goals;
};

/// nothing if a cell was not measured
std::optional<GoalResult> evaluate(const Goal& goal, const std::vector<Table>& tables);

/// Each cell: the median, and in brackets the ratio to the base's cell of the same column.
void print(std::ostream& out, const Table& table);
void print(std::ostream& out, const std::vector<GoalResult>& goals);
nlohmann::json to_json(const Results& results);

}  // namespace meshgrade::bench
