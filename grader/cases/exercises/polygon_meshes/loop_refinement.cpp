#include <algorithm>

#include "grader/base/text.h"
#include "grader/cases/whole_mesh_cases.h"

namespace meshgrade {
namespace {

const WholeMeshExercise& loop_refinement() {
  static const WholeMeshExercise exercise{
      "PolyMesh::loopSubdivide",
      [](std::uint32_t times, const std::string& mesh) {
        return plural(times, "level") + " on " + mesh;
      },
      4, 700,
      [](const PolygonMesh& mesh) {
        return std::all_of(mesh.polygons.begin(), mesh.polygons.end(),
                           [](const auto& corners) { return corners.size() == 3; });
      }};
  return exercise;
}

}  // namespace

void make_loop_refinement_cases(CaseMaker& maker) {
  make_whole_mesh_cases(maker, loop_refinement());
}

void shrink_loop_refinement_case(CaseMaker& maker, const Case& failed) {
  shrink_whole_mesh_case(maker, loop_refinement(), failed);
}

}  // namespace meshgrade
