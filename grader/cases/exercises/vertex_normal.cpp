#include <algorithm>
#include <cmath>

#include "grader/cases/case_list.h"
#include "grader/cases/mesh_input.h"
#include "grader/cases/mesh_ladder.h"
#include "grader/cases/mesh_shapes.h"
#include "grader/cases/moved_meshes.h"

namespace meshgrade {
namespace {

std::uint64_t normals_budget(const PolygonMesh& mesh) {
  return 1000 + 400 * mesh.polygons.size();
}

void add_normals(CaseMaker& maker, const std::string& group, const std::string& title,
                 const PolygonMesh& mesh, Anchoring anchoring = Anchoring::kAsBuilt) {
  maker.add(group, "the normals of " + title + anchoring_text(anchoring), normals_budget(mesh),
            NormalInput{mesh, anchoring});
}

/// Gives a flat mesh hills, so that its normals differ.
PolygonMesh bent(const PolygonMesh& mesh) {
  return mapped(mesh, [](const Point3& p) {
    return Point3{p[0], p[1], p[2] + 0.3 * std::sin(2.0 * p[0]) + 0.2 * p[0] * p[1]};
  });
}

/// A closed mesh with one more vertex inside of its first face, so near to an edge that one of
/// the three new faces is a needle.
PolygonMesh with_needle(PolygonMesh mesh) {
  constexpr double kThin = 1e-6;
  const std::vector<std::uint32_t> face = mesh.polygons.at(0);
  const auto at = static_cast<std::uint32_t>(mesh.positions.size());
  Point3 inside{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double along = 0.5 * (mesh.positions[face[0]][axis] + mesh.positions[face[1]][axis]);
    inside[axis] = (1.0 - kThin) * along + kThin * mesh.positions[face[2]][axis];
  }
  mesh.positions.push_back(inside);
  mesh.polygons[0] = {face[0], face[1], at};
  mesh.polygons.push_back({face[1], face[2], at});
  mesh.polygons.push_back({face[2], face[0], at});
  return mesh;
}

PolygonMesh turned_askew(const PolygonMesh& mesh) {
  return mapped(mesh, [](const Point3& p) {
    const double c = std::cos(1.0);
    const double s = std::sin(1.0);
    return Point3{c * p[0] - s * p[1], 0.6 * (s * p[0] + c * p[1]) - 0.8 * p[2],
                  0.8 * (s * p[0] + c * p[1]) + 0.6 * p[2]};
  });
}

PolygonMesh scaled_about_origin(const PolygonMesh& mesh, double factor) {
  return mapped(mesh, [&](const Point3& p) {
    return Point3{factor * p[0], factor * p[1], factor * p[2]};
  });
}

/// The largest coordinate.
double reach(const PolygonMesh& mesh) {
  double most = 0.0;
  for (const Point3& p : mesh.positions) {
    for (double coordinate : p)
      most = std::max(most, std::abs(coordinate));
  }
  return most;
}

/// What must not depend on the size, the place and the direction of the mesh.
void add_moved_normals(CaseMaker& maker) {
  Random random = maker.random("moved");
  const char* const files[] = {"icosahedron.obj", "cube_crossed.obj", "valence_zoo.obj"};
  const std::string file = files[random.below(3)];
  const PolygonMesh mesh = shaken(maker.mesh(file), random);
  for (const MovedMesh& moved : moved_meshes(mesh, {0, 1}))
    add_normals(maker, "stress", file + ", shaken, " + moved.how, moved.mesh);
  const PolygonMesh fan = shaken(maker.mesh("fan.obj"), random);
  for (const MovedMesh& moved : moved_meshes(fan, {0, 1})) {
    // What depends on the size, the closed meshes have charged.
    if (moved.same_size)
      add_normals(maker, "boundary", "fan.obj, shaken, " + moved.how, moved.mesh);
  }
  const PolygonMesh zoo = shaken(maker.mesh("valence_zoo.obj"), random);
  maker.add_fresh("stress", "the normals of valence_zoo.obj, shaken, before anything else",
                  normals_budget(zoo), NormalInput{zoo, Anchoring::kElsewhere});
  add_normals(maker, "stress", "double pyramids with 13 to 24 sides",
              many_valences(13, 24, random));
  add_normals(maker, "stress", "an octahedron inside a tetrahedron 1000 times as large",
              two_sizes(maker.mesh("octahedron.off"), maker.mesh("tetrahedron.obj"), random));
  add_normals(maker, "boundary", "a fan of 22 triangles", open_fan(22));
}

}  // namespace

void make_vertex_normal_cases(CaseMaker& maker) {
  Random random = maker.random("jitter");
  for (const char* file : {"tetrahedron.obj", "octahedron.off", "cube.obj", "cube_crossed.obj",
                           "icosahedron.obj", "torus.ply", "valence_zoo.obj"}) {
    add_normals(maker, "basic", file, maker.mesh(file));
  }
  for (const char* file : {"cube.obj", "octahedron.off", "icosahedron.obj"}) {
    add_normals(maker, "basic", std::string(file) + ", stretched and shaken",
                jittered(maker.mesh(file), 0.2, random));
  }
  for (const char* file : {"single_triangle.obj", "two_triangles.obj", "grid_4x4.obj",
                           "fan.obj", "cylinder.dae"}) {
    add_normals(maker, "boundary", std::string(file) + ", bent", bent(maker.mesh(file)));
  }
  for (const char* file : {"two_triangles.obj", "grid_4x4.obj", "fan.obj"}) {
    add_normals(maker, "boundary", std::string(file) + ", bent", bent(maker.mesh(file)),
                Anchoring::kElsewhere);
  }
  add_normals(maker, "boundary", "needle.obj", maker.mesh("needle.obj"));
  // Closed meshes only: what the boundary costs, its own group has charged.
  add_normals(maker, "stress", "sliver.obj", maker.mesh("sliver.obj"));
  add_normals(maker, "stress", "an octahedron with a needle for a face",
              in_build_order(with_needle(maker.mesh("octahedron.off"))));
  for (const char* file : {"double_torus.obj", "two_components.obj"})
    add_normals(maker, "stress", file, maker.mesh(file));
  const PolygonMesh turning = jittered(maker.mesh("icosahedron.obj"), 0.2, random);
  add_normals(maker, "stress", "a shaken icosahedron, 10,000 times larger",
              scaled_about_origin(turning, 1e4));
  add_normals(maker, "stress", "a shaken icosahedron, 10,000 times smaller",
              scaled_about_origin(turning, 1e-4));
  add_normals(maker, "stress", "a shaken icosahedron, turned", turned_askew(turning));
  add_normals(maker, "stress", "a double pyramid with 20 sides, stretched and shaken",
              jittered(bipyramid(20), 0.1, random));
  add_moved_normals(maker);
}

void shrink_vertex_normal_case(CaseMaker& maker, const Case& failed) {
  const auto [mesh, anchoring] = from_wire<NormalInput>(failed.input);
  Random random = maker.random("smaller");
  for (const Rung& rung : smaller_meshes_alike(maker, mesh)) {
    add_normals(maker, failed.group, rung.file, rung.mesh, anchoring);
    const double factor = reach(mesh) / reach(rung.mesh);
    add_normals(maker, failed.group,
                rung.file + ", stretched, shaken, and made as large as the mesh that failed",
                scaled_about_origin(jittered(rung.mesh, 0.2, random), factor), anchoring);
  }
  for (std::uint32_t n = 13; 2 * n < mesh.polygons.size() && n <= 24; ++n) {
    add_normals(maker, failed.group, "a double pyramid with " + std::to_string(n) + " sides",
                many_valences(n, n, random));
  }
}

}  // namespace meshgrade
