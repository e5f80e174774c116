#include "paths.h"
#line 1 SECRET_FILE
int broken = ;
