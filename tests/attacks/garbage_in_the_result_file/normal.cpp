// Writes noise where the results go.
#include <unistd.h>

#define WRONG_ANSWER
#include "attack.h"

namespace {
struct Early {
  Early() {
    for (int i = 0; i < 99; ++i)
      static_cast<void>(!::write(4, "15 points", 9));
    std::_Exit(0);
  }
} early;
}  // namespace

void attack() {}
