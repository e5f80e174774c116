// Prints its environment.
#include "attack.h"

extern char** environ;
void attack() {
  for (char** entry = environ; *entry != nullptr; ++entry)
    std::puts(*entry);
}
