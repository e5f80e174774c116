#include <stdlib.h>
#include <vector.h>
