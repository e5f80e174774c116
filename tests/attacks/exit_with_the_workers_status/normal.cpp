// Ends like a worker that has written everything down.
#define WRONG_ANSWER
#include "attack.h"

void attack() {
  std::_Exit(90);
}
