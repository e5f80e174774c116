// Gives itself steps without end, and walks.
#include <cstdint>

#include "attack.h"

void attack() {
  for (;;)
    meshedit::detail::steps_left = INT64_MAX;
}
