// Brings files along that tools for building would obey.
#include "attack.h"

void attack() {}
