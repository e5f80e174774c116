// Takes a gigabyte of stack.
#include "attack.h"

void attack() {
  volatile std::size_t size = std::size_t{1} << 30U;
  volatile char* room = static_cast<char*>(__builtin_alloca(size));
  room[0] = 1;
}
