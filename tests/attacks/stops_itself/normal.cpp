// Stops, and waits to be continued.
#include <csignal>

#include "attack.h"

void attack() {
  std::raise(SIGSTOP);
}
