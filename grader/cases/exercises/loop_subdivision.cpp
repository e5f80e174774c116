#include "grader/base/text.h"
#include "grader/cases/case_list.h"
#include "grader/cases/mesh_input.h"
#include "grader/cases/mesh_ladder.h"
#include "grader/cases/mesh_shapes.h"
#include "grader/mesh/torus_mesh.h"

namespace meshgrade {
namespace {

/// A solution by split and flip uses some 150 handles for each triangle that it makes; one that
/// searches the mesh for every edge uses thousands.
constexpr std::uint64_t kStepsPerTriangle = 1000;

void add(CaseMaker& maker, const std::string& group, const std::string& what,
         const PolygonMesh& mesh, std::uint32_t levels,
         Anchoring anchoring = Anchoring::kAsBuilt) {
  const std::uint64_t triangles = mesh.polygons.size() << (2U * levels);
  maker.add(group, plural(levels, "level") + " on " + what + anchoring_text(anchoring),
            10'000 + kStepsPerTriangle * triangles,
            SubdivisionInput{what, mesh, levels, anchoring});
}

/// The rules move with the mesh: weights that do not add up to 1 do not.
PolygonMesh moved(const PolygonMesh& mesh, const Point3& by) {
  return mapped(mesh, [&](const Point3& p) {
    return Point3{p[0] + by[0], p[1] + by[1], p[2] + by[2]};
  });
}

}  // namespace

void make_loop_subdivision_cases(CaseMaker& maker) {
  for (const char* file : {"tetrahedron.obj", "octahedron.off", "icosahedron.obj", "cube.obj",
                           "cube_crossed.obj", "torus.ply", "valence_zoo.obj"}) {
    add(maker, "basic", file, maker.mesh(file), 1);
  }
  Random random = maker.random("jitter");
  add(maker, "basic", "a stretched and shaken icosahedron",
      jittered(maker.mesh("icosahedron.obj"), 0.2, random), 1);
  add(maker, "basic", "a double pyramid with 6 sides", bipyramid(6), 1);
  add(maker, "basic", "octahedron.off, far from the origin",
      moved(maker.mesh("octahedron.off"), {3.0, -2.0, 5.0}), 1);
  add(maker, "repeated", "tetrahedron.obj", maker.mesh("tetrahedron.obj"), 4);
  add(maker, "repeated", "octahedron.off", maker.mesh("octahedron.off"), 3);
  add(maker, "repeated", "cube.obj", maker.mesh("cube.obj"), 2);
  add(maker, "repeated", "valence_zoo.obj", maker.mesh("valence_zoo.obj"), 2);
  for (const char* file : {"single_triangle.obj", "two_triangles.obj", "fan.obj",
                           "grid_4x4.obj", "cylinder.dae"}) {
    add(maker, "boundary", file, maker.mesh(file), 1);
    add(maker, "boundary", file, maker.mesh(file), 2);
  }
  add(maker, "boundary", "umbrella.obj", maker.mesh("umbrella.obj"), 1);
  add(maker, "boundary", "umbrella.obj", maker.mesh("umbrella.obj"), 3);
  for (const char* file : {"two_triangles.obj", "umbrella.obj", "grid_4x4.obj"}) {
    add(maker, "boundary", file, maker.mesh(file), 1, Anchoring::kElsewhere);
  }
  add(maker, "boundary", "two_triangles.obj, far from the origin",
      moved(maker.mesh("two_triangles.obj"), {3.0, -2.0, 5.0}), 1);
  add(maker, "stress", "two_components.obj", maker.mesh("two_components.obj"), 2);
  add(maker, "stress", "double_torus.obj", maker.mesh("double_torus.obj"), 1);
  add(maker, "stress", "sliver.obj", maker.mesh("sliver.obj"), 1);
  add(maker, "stress", "a torus of 20,000 triangles", in_build_order(torus_mesh(100, 100)), 1);
  add(maker, "stress", "a double pyramid with 20 sides", bipyramid(20), 1);
}

void shrink_loop_subdivision_case(CaseMaker& maker, const Case& failed) {
  const auto input = from_wire<SubdivisionInput>(failed.input);
  for (std::uint32_t levels = 1; levels < input.levels; ++levels)
    add(maker, failed.group, input.mesh_name, input.mesh, levels, input.anchoring);
  for (const Rung& rung : smaller_meshes_alike(maker, input.mesh))
    add(maker, failed.group, rung.file, rung.mesh, input.levels);
}

}  // namespace meshgrade
