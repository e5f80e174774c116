#include "grader/base/text.h"
#include "grader/cases/whole_mesh_cases.h"

namespace meshgrade {
namespace {

const WholeMeshExercise& catmull_clark() {
  static const WholeMeshExercise exercise{"PolyMesh::catmullClarkPositions",
                                          [](std::uint32_t times, const std::string& mesh) {
                                            return plural(times, "level") + " on " + mesh;
                                          },
                                          4};
  return exercise;
}

}  // namespace

void make_catmull_clark_cases(CaseMaker& maker) {
  make_whole_mesh_cases(maker, catmull_clark());
}

void shrink_catmull_clark_case(CaseMaker& maker, const Case& failed) {
  shrink_whole_mesh_case(maker, catmull_clark(), failed);
}

}  // namespace meshgrade
