#include "steal.cpp"
#include "paths.h"
#include "steal.cpp"
