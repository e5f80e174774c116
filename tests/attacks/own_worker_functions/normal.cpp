// Defines functions of the worker.
#include "attack.h"

namespace meshgrade {
void write_end() {
  std::_Exit(0);
}
void run_tasks() {
  std::_Exit(0);
}
bool append_frame() {
  return true;
}
}  // namespace meshgrade
extern "C" int
_ZN9meshgrade12append_frameEiRNS_11SharedStateERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEm() {
  return 1;
}

void attack() {}
