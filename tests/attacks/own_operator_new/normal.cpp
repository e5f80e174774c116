// Defines operator new, for itself only.
#include "attack.h"

void* operator new(std::size_t) {
  std::_Exit(0);
}
void operator delete(void*) noexcept {
  std::_Exit(0);
}

void attack() {}
