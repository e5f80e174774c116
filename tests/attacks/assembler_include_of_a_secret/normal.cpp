// Lets the assembler read a file of the instructor.
#include "attack.h"

void attack() {}
