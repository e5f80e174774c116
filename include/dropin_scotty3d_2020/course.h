#pragma once

// The grader includes this file before every file of a homework for Scotty3D of Fall 2020 to
// Spring 2022: what the course's headers let their files use.

#include <cassert>

#include "geometry/halfedge.h"
