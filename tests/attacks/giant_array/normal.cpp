// Makes an object file of gigabytes.
#include "attack.h"

void attack() {}
