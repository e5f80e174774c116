#include "paths.h"
constexpr int big[200000000] = {1};
constexpr int sum() {
  int s = 0;
  for (int v : big)
    s += v;
  return s;
}
static_assert(sum() == 2);
