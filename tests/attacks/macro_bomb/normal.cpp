// Expands a macro to billions of tokens.
#include "attack.h"

void attack() {}
