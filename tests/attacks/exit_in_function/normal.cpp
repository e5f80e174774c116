// Ends in the first call, with success.
#define WRONG_ANSWER
#include "attack.h"

void attack() {
  std::_Exit(0);
}
