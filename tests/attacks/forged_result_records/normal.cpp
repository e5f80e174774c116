// Writes well-formed records: every case is done.
#include <unistd.h>
#include <cstdint>

#define WRONG_ANSWER
#include "attack.h"

namespace {
struct Early {
  Early() {
    for (std::uint32_t task = 0; task < 99; ++task) {
      const std::uint32_t end[] = {1, task, 0, 0, 0};  // kind, task, done, no fault, no code
      const std::uint64_t nothing[] = {0, 0, 0, 0, 0};
      const std::uint64_t length = sizeof end + sizeof nothing;
      put(&length, sizeof length);
      put(end, sizeof end);
      put(nothing, sizeof nothing);
    }
    std::_Exit(0);
  }
  static void put(const void* data, std::size_t size) {
    static_cast<void>(!::write(4, data, size));
  }
} early;
}  // namespace

void attack() {}
