#include "grader/operations/cut_corners.h"

namespace meshgrade {
namespace {

Answer vertex_bevel_answer(const FaceLists& before, const Picked& picked) {
  if (Surface(before).neighbours(picked.corners[0]).size() < 3)
    return refuse(before, "it has two edges only, and the new face would have two corners");
  return settle(cut_corners(before, picked.corners));
}

}  // namespace

LocalOperation vertex_bevel_operation() {
  return {"vertex_bevel",
          "PolyMesh::bevelVertex",
          "bevel",
          ElementKind::kVertex,
          ElementKind::kFace,
          vertex_bevel_answer,
          "a corner and a side of the new face for each edge of the vertex, and the vertex "
          "itself goes"};
}

}  // namespace meshgrade
