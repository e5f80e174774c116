#include "paths.h"
#include SECRET_FILE
