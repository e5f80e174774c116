// Starts its own program again, with a library in front.
#include <unistd.h>

#define WRONG_ANSWER
#include "attack.h"

void attack() {
  char* const arguments[] = {const_cast<char*>("worker"), nullptr};
  char* const environment[] = {const_cast<char*>("LD_PRELOAD=./evil.so"), nullptr};
  ::execve("worker", arguments, environment);
  ::execve("./worker", arguments, environment);
}
