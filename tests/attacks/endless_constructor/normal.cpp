// Never comes to main.
#include "attack.h"

namespace {
struct Early {
  Early() {
    for (volatile int i = 0;; i = i + 1) {
    }
  }
} early;
}  // namespace

void attack() {}
