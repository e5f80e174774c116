// Claims that a mistake stands in a file of the instructor, which the compiler then shows.
#include "attack.h"

void attack() {}
