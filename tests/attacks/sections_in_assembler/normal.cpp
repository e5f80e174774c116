// Changes how the program is linked and loaded, in assembler.
#include "attack.h"

void attack() {}
