// Includes the reference, which would solve the exercise.
#include "attack.h"

void attack() {}
