#include "grader/base/text.h"
#include "grader/cases/case_list.h"
#include "grader/cases/mesh_input.h"
#include "grader/cases/mesh_ladder.h"
#include "grader/cases/mesh_shapes.h"
#include "grader/cases/moved_meshes.h"
#include "grader/mesh/torus_mesh.h"

namespace meshgrade {
namespace {

/// A solution by split and flip uses some 150 handles for each triangle that it makes; one that
/// searches the mesh for every edge uses thousands.
constexpr std::uint64_t kStepsPerTriangle = 1000;

std::uint64_t subdivision_budget(const PolygonMesh& mesh, std::uint32_t levels) {
  const std::uint64_t triangles = mesh.polygons.size() << (2U * levels);
  return 10'000 + kStepsPerTriangle * triangles;
}

void add_subdivision(CaseMaker& maker, const std::string& group, const std::string& what,
                     const PolygonMesh& mesh, std::uint32_t levels,
                     Anchoring anchoring = Anchoring::kAsBuilt) {
  maker.add(group, plural(levels, "level") + " on " + what + anchoring_text(anchoring),
            subdivision_budget(mesh, levels), SubdivisionInput{what, mesh, levels, anchoring});
}

/// What must not depend on the size, the place and the direction of the mesh; also not what a
/// second level finds of the first. The tetrahedron is there for its valence.
void add_moved_subdivisions(CaseMaker& maker) {
  Random random = maker.random("moved");
  const char* const files[] = {"octahedron.off", "cube.obj", "cube_crossed.obj"};
  const std::string file = files[random.below(3)];
  const PolygonMesh mesh =
      shaken(side_by_side(maker.mesh("tetrahedron.obj"), maker.mesh(file)), random);
  for (const MovedMesh& moved : moved_meshes(mesh, {0, 1}))
    add_subdivision(maker, "stress", "tetrahedron.obj and " + file + ", shaken, " + moved.how,
                    moved.mesh, 2);
  // With every valence from 3 to 12: a third call may be wrong for one of them only.
  const PolygonMesh fresh = shaken(maker.mesh("valence_zoo.obj"), random);
  maker.add_fresh("stress", "3 levels on valence_zoo.obj, shaken, before anything else",
                  subdivision_budget(fresh, 3),
                  SubdivisionInput{"valence_zoo.obj, shaken", fresh, 3});
  const PolygonMesh alone = shaken(maker.mesh("octahedron.off"), random);
  for (const Anchoring anchoring : {Anchoring::kElsewhere, Anchoring::kFromEarlier}) {
    maker.add_fresh("stress",
                    "1 level on octahedron.off, shaken, before anything else" +
                        std::string(anchoring_text(anchoring)),
                    subdivision_budget(alone, 1),
                    SubdivisionInput{"octahedron.off, shaken", alone, 1, anchoring});
  }
  add_subdivision(maker, "stress", "double pyramids with 13 to 24 sides",
                  beginning_at_highest_valence(many_valences(13, 24, random)), 1);
  add_subdivision(maker, "stress", "a torus of 128 triangles", in_build_order(torus_mesh(8, 8)),
                  2);
  add_subdivision(
      maker, "stress", "an octahedron inside a tetrahedron 1000 times as large",
      two_sizes(maker.mesh("octahedron.off"), maker.mesh("tetrahedron.obj"), random), 1);
  const PolygonMesh fan = shaken(maker.mesh("fan.obj"), random);
  for (const MovedMesh& moved : moved_meshes(fan, {0, 1}))
    add_subdivision(maker, "boundary", "fan.obj, shaken, " + moved.how, moved.mesh, 2);
  add_subdivision(maker, "boundary", "a fan of 22 triangles",
                  beginning_at_highest_valence(open_fan(22)), 1);
  add_subdivision(maker, "boundary", "a square of 512 triangles", open_grid(16, random), 1);
  add_subdivision(maker, "boundary", "a square of 128 triangles", open_grid(8, random), 2);
  maker.add_fresh("boundary", "3 levels on fan.obj, shaken, before anything else",
                  subdivision_budget(fan, 3), SubdivisionInput{"fan.obj, shaken", fan, 3});
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
    add_subdivision(maker, "basic", file, maker.mesh(file), 1);
  }
  Random random = maker.random("jitter");
  add_subdivision(maker, "basic", "a stretched and shaken icosahedron",
                  jittered(maker.mesh("icosahedron.obj"), 0.2, random), 1);
  add_subdivision(maker, "basic", "a double pyramid with 6 sides", bipyramid(6), 1);
  add_subdivision(maker, "basic", "octahedron.off, far from the origin",
                  moved(maker.mesh("octahedron.off"), {3.0, -2.0, 5.0}), 1);
  add_subdivision(maker, "repeated", "tetrahedron.obj", maker.mesh("tetrahedron.obj"), 4);
  add_subdivision(maker, "repeated", "octahedron.off", maker.mesh("octahedron.off"), 3);
  add_subdivision(maker, "repeated", "cube.obj", maker.mesh("cube.obj"), 2);
  add_subdivision(maker, "repeated", "valence_zoo.obj", maker.mesh("valence_zoo.obj"), 2);
  for (const char* file : {"single_triangle.obj", "two_triangles.obj", "fan.obj",
                           "grid_4x4.obj", "cylinder.dae"}) {
    add_subdivision(maker, "boundary", file, maker.mesh(file), 1);
    add_subdivision(maker, "boundary", file, maker.mesh(file), 2);
  }
  add_subdivision(maker, "boundary", "umbrella.obj", maker.mesh("umbrella.obj"), 1);
  add_subdivision(maker, "boundary", "umbrella.obj", maker.mesh("umbrella.obj"), 3);
  for (const char* file : {"two_triangles.obj", "umbrella.obj", "grid_4x4.obj"}) {
    add_subdivision(maker, "boundary", file, maker.mesh(file), 1, Anchoring::kElsewhere);
  }
  add_subdivision(maker, "boundary", "two_triangles.obj, far from the origin",
                  moved(maker.mesh("two_triangles.obj"), {3.0, -2.0, 5.0}), 1);
  add_subdivision(maker, "stress", "octahedron.off", maker.mesh("octahedron.off"), 1,
                  Anchoring::kFromEarlier);
  add_subdivision(maker, "boundary", "grid_4x4.obj", maker.mesh("grid_4x4.obj"), 1,
                  Anchoring::kFromEarlier);
  add_subdivision(maker, "stress", "two_components.obj", maker.mesh("two_components.obj"), 2);
  add_subdivision(maker, "stress", "double_torus.obj", maker.mesh("double_torus.obj"), 1);
  add_subdivision(maker, "stress", "sliver.obj", maker.mesh("sliver.obj"), 1);
  add_subdivision(maker, "stress", "a torus of 20,000 triangles",
                  in_build_order(torus_mesh(100, 100)), 1);
  add_subdivision(maker, "stress", "a double pyramid with 20 sides", bipyramid(20), 1);
  add_moved_subdivisions(maker);
}

void shrink_loop_subdivision_case(CaseMaker& maker, const Case& failed) {
  const auto input = from_wire<SubdivisionInput>(failed.input);
  for (std::uint32_t levels = 1; levels < input.levels; ++levels)
    add_subdivision(maker, failed.group, input.mesh_name, input.mesh, levels, input.anchoring);
  for (const Rung& rung : smaller_meshes_alike(maker, input.mesh))
    add_subdivision(maker, failed.group, rung.file, rung.mesh, input.levels);
  Random random = maker.random("smaller");
  for (std::uint32_t n = 13; 2 * n < input.mesh.polygons.size() && n <= 24; ++n) {
    add_subdivision(maker, failed.group,
                    "a double pyramid with " + std::to_string(n) + " sides",
                    many_valences(n, n, random), input.levels);
  }
}

}  // namespace meshgrade
