// Calls itself without end.
#include "attack.h"

namespace {
int deep(int n) {
  volatile char room[999] = {};
  return deep(n + 1) + room[n % 9];
}
}  // namespace
void attack() {
  std::printf("%d\n", deep(1));
}
