// Makes the compiler say commands for terminals.
#include "attack.h"

void attack() {}
