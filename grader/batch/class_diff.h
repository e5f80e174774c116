#pragma once

#include <string>
#include <vector>

#include "grader/batch/class_results.h"

namespace meshgrade {

/// A case that has another verdict than before; a name that is not there is empty.
struct CaseChange {
  std::string id;
  std::string before;
  std::string after;
};

/// Somebody whose points or status changed.
struct RowChange {
  std::string key;
  std::string before;  ///< "87 points", "ungradable"; "not there"
  std::string after;
  double difference = 0.0;        ///< of the points, extra credit counted
  std::vector<CaseChange> cases;  ///< those of the exercises whose points changed
};

/// The hand-ins whose points or status differ, by key.
std::vector<RowChange> compare_classes(const ClassResults& old_results,
                                       const ResultStore& old_store,
                                       const ClassResults& new_results,
                                       const ResultStore& new_store);

/// For people to read; `most_cases` are named of each hand-in.
std::string to_text(const std::vector<RowChange>& changes, std::size_t most_cases);

}  // namespace meshgrade
