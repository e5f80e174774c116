#include <algorithm>
#include <cmath>

#include "grader/cases/case_list.h"
#include "grader/cases/mesh_input.h"
#include "grader/cases/mesh_ladder.h"
#include "grader/cases/mesh_shapes.h"

namespace meshgrade {
namespace {

void add(CaseMaker& maker, const std::string& group, const std::string& title,
         const PolygonMesh& mesh, Anchoring anchoring = Anchoring::kAsBuilt) {
  maker.add(group, "the normals of " + title + anchoring_text(anchoring),
            1000 + 400 * mesh.polygons.size(), NormalInput{mesh, anchoring});
}

/// Gives a flat mesh hills, so that its normals differ.
PolygonMesh bent(const PolygonMesh& mesh) {
  return mapped(mesh, [](const Point3& p) {
    return Point3{p[0], p[1], p[2] + 0.3 * std::sin(2.0 * p[0]) + 0.2 * p[0] * p[1]};
  });
}

PolygonMesh turned(const PolygonMesh& mesh) {
  return mapped(mesh, [](const Point3& p) {
    const double c = std::cos(1.0);
    const double s = std::sin(1.0);
    return Point3{c * p[0] - s * p[1], 0.6 * (s * p[0] + c * p[1]) - 0.8 * p[2],
                  0.8 * (s * p[0] + c * p[1]) + 0.6 * p[2]};
  });
}

PolygonMesh scaled(const PolygonMesh& mesh, double factor) {
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

}  // namespace

void make_vertex_normal_cases(CaseMaker& maker) {
  Random random = maker.random("jitter");
  for (const char* file : {"tetrahedron.obj", "octahedron.off", "cube.obj", "cube_crossed.obj",
                           "icosahedron.obj", "torus.ply", "valence_zoo.obj"}) {
    add(maker, "basic", file, maker.mesh(file));
  }
  for (const char* file : {"cube.obj", "octahedron.off", "icosahedron.obj"}) {
    add(maker, "basic", std::string(file) + ", stretched and shaken",
        jittered(maker.mesh(file), 0.2, random));
  }
  for (const char* file : {"single_triangle.obj", "two_triangles.obj", "grid_4x4.obj",
                           "fan.obj", "cylinder.dae"}) {
    add(maker, "boundary", std::string(file) + ", bent", bent(maker.mesh(file)));
  }
  for (const char* file : {"two_triangles.obj", "grid_4x4.obj", "fan.obj"}) {
    add(maker, "boundary", std::string(file) + ", bent", bent(maker.mesh(file)),
        Anchoring::kElsewhere);
  }
  for (const char* file :
       {"sliver.obj", "needle.obj", "double_torus.obj", "two_components.obj"}) {
    add(maker, "stress", file, maker.mesh(file));
  }
  const PolygonMesh shaken = jittered(maker.mesh("icosahedron.obj"), 0.2, random);
  add(maker, "stress", "a shaken icosahedron, 10,000 times larger", scaled(shaken, 1e4));
  add(maker, "stress", "a shaken icosahedron, 10,000 times smaller", scaled(shaken, 1e-4));
  add(maker, "stress", "a shaken icosahedron, turned", turned(shaken));
  add(maker, "stress", "a double pyramid with 20 sides, stretched and shaken",
      jittered(bipyramid(20), 0.1, random));
}

void shrink_vertex_normal_case(CaseMaker& maker, const Case& failed) {
  const auto [mesh, anchoring] = from_wire<NormalInput>(failed.input);
  Random random = maker.random("smaller");
  for (const Rung& rung : smaller_meshes_alike(maker, mesh)) {
    add(maker, failed.group, rung.file, rung.mesh, anchoring);
    const double factor = reach(mesh) / reach(rung.mesh);
    add(maker, failed.group,
        rung.file + ", stretched, shaken, and made as large as the mesh that failed",
        scaled(jittered(rung.mesh, 0.2, random), factor), anchoring);
  }
}

}  // namespace meshgrade
