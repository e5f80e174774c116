// Asks the compiler to load code.
#include "attack.h"

void attack() {}
