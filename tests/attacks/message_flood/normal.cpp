// Makes the compiler complain without end.
#include "attack.h"

void attack() {}
