// Opens files and never closes them.
#include <fcntl.h>

#include "attack.h"

void attack() {
  while (::open("/dev/null", O_RDONLY) >= 0) {
  }
}
