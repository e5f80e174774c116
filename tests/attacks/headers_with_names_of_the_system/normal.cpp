// Brings headers along that stand in for those of the system.
#include "attack.h"

void attack() {}
