#include "grader/operations/contraction.h"

namespace meshgrade {
namespace {

Answer edge_collapse_answer(const FaceLists& before, const Picked& picked) {
  return contract(before, picked.corners,
                  {"both of its ends lie on a boundary, and the edge itself does not",
                   "another face than those beside it has both of its ends",
                   "the third corner of a triangle beside it would have one edge only"});
}

}  // namespace

LocalOperation edge_collapse_operation() {
  return {
      "edge_collapse",
      "PolyMesh::collapseEdge",
      "collapse",
      ElementKind::kEdge,
      ElementKind::kVertex,
      edge_collapse_answer,
      "one vertex and one edge go; with each triangle beside the edge one edge and one face "
      "more"};
}

}  // namespace meshgrade
