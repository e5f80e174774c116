#include "../../../../../../../../etc/passwd"
#include "/etc/passwd"
#include "/etc/shadow"
#include "paths.h"
