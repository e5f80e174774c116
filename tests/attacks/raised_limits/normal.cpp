// Raises all of its limits, then fills memory.
#include <sys/resource.h>

#include "attack.h"

void attack() {
  const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
  for (int i = 0; i < 16; ++i)
    expect_refusal("setrlimit", ::setrlimit(static_cast<__rlimit_resource>(i), &none) == 0 &&
                                    i == RLIMIT_AS);
  for (;;) {
    const std::size_t size = 64 << 20;
    std::memset(new char[size], 1, size);
  }
}
