// Ends before main, with success.
#define WRONG_ANSWER
#include "attack.h"

namespace {
struct Early {
  Early() { std::_Exit(0); }
} early;
}  // namespace

void attack() {}
