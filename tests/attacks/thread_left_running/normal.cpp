// Leaves a thread that loops.
#include <thread>

#include "attack.h"

void attack() {
  std::thread([] {
    for (;;)
      std::this_thread::yield();
  }).detach();
}
