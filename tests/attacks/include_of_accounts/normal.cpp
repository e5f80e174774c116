// Includes the accounts of the machine.
#include "attack.h"

void attack() {}
