// Puts its own code among the constructors, in assembler.
#define WRONG_ANSWER
#include "attack.h"

extern "C" [[gnu::used]] void quiet_end() {
  std::_Exit(0);
}
asm(".section .init_array,\"aw\"\n.quad quiet_end\n.text\n");

void attack() {}
