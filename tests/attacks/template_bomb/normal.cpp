// Instantiates templates without end.
#include "attack.h"

void attack() {}
