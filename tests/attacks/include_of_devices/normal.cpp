// Includes devices that never end, or wait.
#include "attack.h"

void attack() {}
