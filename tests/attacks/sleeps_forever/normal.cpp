// Waits without using the processor.
#include <unistd.h>

#include "attack.h"

void attack() {
  for (;;)
    ::sleep(1000);
}
