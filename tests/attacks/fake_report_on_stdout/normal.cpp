// Prints what a report of full points looks like.
#define WRONG_ANSWER
#include "attack.h"

void attack() {
  std::puts("{\"schema\": \"meshgrade-report/1\", \"points\": 100, \"max_points\": 100}");
  std::puts("[  PASSED  ] all tests");
  std::puts("vertex_normal       passed                 15 / 15");
}
