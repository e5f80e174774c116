#include "grader/base/text.h"
#include "grader/cases/whole_mesh_cases.h"

namespace meshgrade {
namespace {

const WholeMeshExercise& linear_subdivision() {
  static const WholeMeshExercise exercise{"PolyMesh::linearPositions",
                                          [](std::uint32_t times, const std::string& mesh) {
                                            return plural(times, "level") + " on " + mesh;
                                          },
                                          4};
  return exercise;
}

}  // namespace

void make_linear_subdivision_cases(CaseMaker& maker) {
  make_whole_mesh_cases(maker, linear_subdivision());
}

void shrink_linear_subdivision_case(CaseMaker& maker, const Case& failed) {
  shrink_whole_mesh_case(maker, linear_subdivision(), failed);
}

}  // namespace meshgrade
