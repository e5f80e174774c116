// Puts a file of the instructor into its data.
#include "attack.h"

void attack() {}
