// Starts threads without end.
#include <pthread.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  for (;;) {
    pthread_t thread{};
    ::pthread_create(
        &thread, nullptr,
        [](void*) -> void* {
          for (;;)
            ::sleep(9);
        },
        nullptr);
  }
}
