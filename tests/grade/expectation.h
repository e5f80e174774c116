#pragma once

// What a submission in tests/submissions must be told. Its folder says it in expected.toml:
//
//   verdict = "failed"          of the exercise
//   rule = "anchor"             of the finding that the student sees first; none if left out
//   points = 14                 without extra credit; [10, 18] is a range
//   extra_points = 5            nothing is asked if left out
//   says = ["h4.next"]          texts that the student's page on the exercise contains
//   probably = ["t-swapped"]    misconceptions that are named in any of its cases; none if left
//                               out
//
//   [others]                    other exercises that are graded along, and their verdicts
//   edge_split = "passed"
//
//   [limits]                    tighter limits than the assignment's, to be quick
//   run_seconds = 1
//
//   [options]                   of the exercise, in place of the assignment's
//   vertex_rule = "loop"
//
// A folder in right/ needs the file only if it does not get all the extra credit (points and
// extra_points are then of the whole assignment) or if it is complete, without the reference:
//
//   alone = true

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "grader/assignment/assignment.h"

namespace meshgrade {

struct Expectation {
  std::string verdict = "passed";
  std::string rule;
  std::optional<double> points;       ///< the least, if there is a range
  std::optional<double> most_points;  ///< of a range
  std::optional<double> extra_points;
  std::vector<std::string> says;
  std::set<std::string> probably;
  std::map<std::string, std::string> others;
  std::map<std::string, std::string> options;
  bool alone = false;
  std::vector<std::pair<std::uint32_t Limits::*, std::uint32_t>> limits;
};

/// Reads expected.toml of this folder; what is not there keeps its standard value.
/// @throws std::runtime_error for a file that is no TOML or has an unknown key
Expectation read_expectation(const std::filesystem::path& folder);

}  // namespace meshgrade
