// Nests brackets until the compiler overflows its stack.
#include "attack.h"

void attack() {}
