#include "grader/cases/whole_mesh_cases.h"

namespace meshgrade {
namespace {

const WholeMeshExercise& triangulation() {
  // Twice: what consists of triangles already must stay as it is.
  static const WholeMeshExercise exercise{"PolyMesh::triangulate",
                                          [](std::uint32_t times, const std::string& mesh) {
                                            return "triangulate " + mesh +
                                                   (times == 1 ? "" : ", twice");
                                          },
                                          2};
  return exercise;
}

}  // namespace

void make_triangulation_cases(CaseMaker& maker) {
  make_whole_mesh_cases(maker, triangulation());
}

void shrink_triangulation_case(CaseMaker& maker, const Case& failed) {
  shrink_whole_mesh_case(maker, triangulation(), failed);
}

}  // namespace meshgrade
