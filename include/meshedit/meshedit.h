#pragma once

// Everything that a solution needs. Read halfedge_mesh.h first: it explains the mesh.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bezier.h"
#include "fault.h"
#include "halfedge_mesh.h"
#include "mesh_resampler.h"
#include "poly_mesh.h"
#include "vector2d.h"
#include "vector3d.h"
