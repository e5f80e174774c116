// OpenMesh as a second opinion on what collapses, and to what.

#include <gtest/gtest.h>

#include <set>

#include "grader/operations/local_operation_list.h"
#include "grader/operations/picked_element.h"
#include "tests/support/openmesh.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

PolyMesh to_openmesh(const FaceLists& lists) {
  auto mesh = openmesh_with_vertices<PolyMesh>(lists.positions);
  for (const Corners& corners : lists.faces) {
    std::vector<OpenMesh::VertexHandle> handles;
    for (Label label : corners)
      handles.push_back(mesh.vertex_handle(label));
    EXPECT_TRUE(mesh.add_face(handles).is_valid());
  }
  return mesh;
}

std::multiset<Corners> faces_of(const PolyMesh& mesh) {
  std::multiset<Corners> faces;
  for (const auto face : mesh.faces()) {
    Corners corners;
    for (const auto v : mesh.fv_range(face))
      corners.push_back(static_cast<Label>(v.idx()));
    faces.insert(canonical(std::move(corners)));
  }
  return faces;
}

/// The faces of an answer, with this vertex for what is new.
std::multiset<Corners> faces_of(const Answer& answer, Label left) {
  std::multiset<Corners> faces;
  for (Corners corners : answer.after.faces) {
    for (Label& label : corners)
      label = label >= answer.first_free ? left : label;
    faces.insert(canonical(std::move(corners)));
  }
  return faces;
}

class OpenMeshCollapse : public testing::TestWithParam<const char*> {};

TEST_P(OpenMeshCollapse, AgreesOnWhatMustBeDoneAndOnWhatIsRefused) {
  const LocalOperation& collapse = *find_local_operation("edge_collapse");
  const MeshDump mesh = sample_dump(GetParam());
  const FaceLists lists = face_lists_of(mesh);
  for (std::uint32_t i = 0; i < count_elements(mesh, ElementKind::kEdge); ++i) {
    const Picked edge = pick(mesh, ElementKind::kEdge, i);
    const Answer answer = collapse.answer(lists, edge);
    if (answer.demand == Demand::kEither) continue;
    for (const std::size_t from : {0U, 1U}) {
      PolyMesh other = to_openmesh(lists);
      const Label left = edge.corners[1 - from];  // OpenMesh keeps where the half-edge ends
      const auto h = other.find_halfedge(other.vertex_handle(edge.corners[from]),
                                         other.vertex_handle(left));
      // OpenMesh 9 does not see that another face has both ends.
      const bool is_overlooked =
          answer.reason == "another face than those beside it has both of its ends";
      const bool is_ok = other.is_collapse_ok(h) && !is_overlooked;
      EXPECT_EQ(is_ok, answer.demand == Demand::kMust) << "edge " << i << ": " << answer.reason;
      if (!is_ok || answer.demand != Demand::kMust) continue;
      other.collapse(h);
      EXPECT_EQ(faces_of(other), faces_of(answer, left)) << "edge " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, OpenMeshCollapse,
                         testing::Values("quad_cube.dae", "prism_5.obj", "pyramid_4.obj",
                                         "dodecahedron.obj", "octahedron.off", "quad_torus.obj",
                                         "bipyramid_3.obj", "pouch.obj", "lens.obj",
                                         "mixed_strip.obj", "quad_grid_3x3.obj", "tube_6.obj",
                                         "ring_5.obj", "fan.obj", "single_triangle.obj",
                                         "single_quad.obj", "valence_zoo.obj", "grid_hole.off"),
                         [](const auto& tested) {
                           const std::string file = tested.param;
                           return file.substr(0, file.find('.'));
                         });

}  // namespace
}  // namespace meshgrade
