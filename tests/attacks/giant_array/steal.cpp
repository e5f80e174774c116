#include "paths.h"
char giant[3000000000] = {1};
char other[3000000000] = {2};
