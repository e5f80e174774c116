#include "/dev/stdin"
#include "/dev/tty"
#include "/dev/zero"
#include "paths.h"
