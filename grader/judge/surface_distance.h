#pragma once

#include "grader/operations/face_lists.h"

namespace meshgrade {

/// The distance of a point from the nearest point of a surface of triangles.
double distance_from(const Point3& point, const FaceLists& surface);

/// How far a surface of triangles is from another one: the root of the mean squared distance of
/// points of each from the other, the larger of the two.
double surface_distance(const FaceLists& one, const FaceLists& other);

/// How far the corner of a surface is from another one that is farthest from it.
double farthest_corner(const FaceLists& one, const FaceLists& other);

}  // namespace meshgrade
