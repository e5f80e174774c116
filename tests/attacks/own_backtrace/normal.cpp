// Defines what the worker calls when code crashes, then crashes.
#define WRONG_ANSWER
#include "attack.h"

extern "C" int backtrace(void**, int) {
  std::_Exit(0);
}
extern "C" int sigaction() {
  return 0;
}
void attack() {
  *reinterpret_cast<volatile int*>(8) = 1;
}
