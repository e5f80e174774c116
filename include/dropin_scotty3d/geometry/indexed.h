#pragma once

// Homework includes it for nothing that is graded.

#include "halfedge.h"
