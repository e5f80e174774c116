// Asks whether a file of the instructor is there.
#include "attack.h"

void attack() {}
