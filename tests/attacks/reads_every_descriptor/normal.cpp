// Prints all that open descriptors give.
#include <unistd.h>

#include "attack.h"

void attack() {
  char text[4096];
  for (int i = 0; i < 64; ++i) {
    for (long at = 0, n = 0; (n = ::pread(i, text, sizeof text, at)) > 0 && at < 100000;
         at += n)
      std::fwrite(text, 1, static_cast<std::size_t>(n), stdout);
  }
}
