#include "paths.h"
asm(".include \"" SECRET_FILE "\"");
