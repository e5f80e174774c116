// Leaves a process that belongs to no session of its own.
#include <unistd.h>

#include "attack.h"

void attack() {
  if (::fork() != 0) return;
  ::setsid();
  if (::fork() != 0) std::_Exit(0);
  for (int i = 0; i < 64; ++i)
    ::close(i);
  for (;;)
    ::sleep(1);
}
