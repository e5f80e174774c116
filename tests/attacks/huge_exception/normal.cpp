// Throws more text than the result file holds.
#include <stdexcept>
#include <string>

#define WRONG_ANSWER
#include "attack.h"

void attack() {
  throw std::runtime_error(std::string(32 << 20, 'x'));
}
