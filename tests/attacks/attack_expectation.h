#pragma once

// What must become of an attack. Its folder says it in expected.toml:
//
//   verdict = "passed"      of the exercise; a list where it depends on the machine's load
//                           which limit comes first; "any": the points alone matter
//   points = 15             what the mesh deserves
//   says = ["steal.cpp"]    texts that the report contains
//   hides = ["root:"]       texts that it does not contain, besides BREACH and the secret
//   layers = [1, 2]         where this is promised; all if left out
//   needs_landlock = 6      the version that layers 2 and 3 need for it; 0 if left out
//
//   [limits]                other limits than those of the attacks' test
//   run_seconds = 1

#include <filesystem>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"

namespace meshgrade {

struct AttackExpectation {
  std::vector<std::string> verdicts;  ///< one of these
  double points = 0.0;
  std::vector<std::string> says;
  std::vector<std::string> hides;
  std::vector<int> layers{1, 2, 3};
  int needs_landlock = 0;
  Limits limits;
};

/// Reads expected.toml of this folder. `limits` are taken where it names none.
/// @throws std::runtime_error for an unknown key, or without verdict and points
AttackExpectation read_attack(const std::filesystem::path& folder, const Limits& limits);

}  // namespace meshgrade
