// Makes the compiler fill its memory.
#include "attack.h"

void attack() {}
