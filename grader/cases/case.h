#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace meshgrade {

/// One thing that a student's function is asked to do.
struct Case {
  std::string exercise;  ///< "edge_split"
  std::string group;     ///< "basic", "boundary", ...: the unit that points are given for
  int number = 0;        ///< from 1, within the group
  std::string title;     ///< what is asked, in plain words: "split v0-v1 of the octahedron"
  std::string input;     ///< packed; each exercise has a struct for it
  std::uint64_t step_budget = 0;  ///< handle uses that a good solution never needs
  bool fresh = false;             ///< run in a process in which nothing was called before
  bool hidden = false;            ///< drawn by the seed that is not handed out
  /// The student's functions that it calls: first the one that it is about, then those whose
  /// work this one may build on. Empty where an exercise has one function.
  std::vector<std::string> calls = {};

  /// "edge_split:boundary/7"
  std::string id() const { return exercise + ":" + group + "/" + std::to_string(number); }
};

inline std::vector<const Case*> pointers_to(const std::vector<Case>& cases) {
  std::vector<const Case*> pointers;
  for (const Case& c : cases)
    pointers.push_back(&c);
  return pointers;
}

}  // namespace meshgrade
