// Looks for the reference and the assignment.
#include "attack.h"

void attack() {
  expect_refusal("reference",
                 std::fopen(PROJECT "/reference/vertex_normal.cpp", "r") != nullptr);
  expect_refusal("assignment", std::fopen(PROJECT "/grader/assignment.toml", "r") != nullptr);
  expect_refusal("kit", std::fopen(PROJECT "/build/release/kit/flags.txt", "r") != nullptr);
}
