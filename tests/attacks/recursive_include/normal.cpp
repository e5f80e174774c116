// Includes itself without end.
#include "attack.h"

void attack() {}
