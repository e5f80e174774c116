#pragma once

#include <string>
#include <vector>

#include "grader/cases/case_list.h"

namespace meshgrade {

struct Rung {
  std::string file;  ///< of the meshes folder
  PolygonMesh mesh;
};

/// The simple meshes that have fewer triangles than `mesh`, the smallest first.
std::vector<Rung> smaller_meshes(const CaseMaker& maker, const PolygonMesh& mesh);

/// The same, but only those with a boundary if each part of `mesh` has one, and only those
/// without if not.
std::vector<Rung> smaller_meshes_alike(const CaseMaker& maker, const PolygonMesh& mesh);

}  // namespace meshgrade
