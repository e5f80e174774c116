#pragma once

// Marks a function that a student's own definition replaces when the worker is linked.
#define MESHGRADE_STUB __attribute__((weak))
