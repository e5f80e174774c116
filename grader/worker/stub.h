#pragma once

#include "meshedit/fault.h"

// Marks a function that a student's own definition replaces when the worker is linked.
#define MESHGRADE_STUB __attribute__((weak))
