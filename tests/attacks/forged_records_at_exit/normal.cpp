// Leaves a handler that writes records when the program ends.
#include <unistd.h>

#define WRONG_ANSWER
#include "attack.h"

void attack() {
  std::atexit([] { static_cast<void>(!::write(4, "\1\0\0\0", 4)); });
}
