#include "grader/cases/moved_meshes.h"
#include "grader/cases/operation_cases.h"
#include "grader/cases/smaller_operations.h"

namespace meshgrade {
namespace {

/// The middle of a short edge, beside long ones.
void add_two_sizes(CaseMaker& maker, Random& random) {
  const PolygonMesh mesh =
      two_sizes(maker.mesh("octahedron.off"), maker.mesh("tetrahedron.obj"), random);
  for (const VertexPair& edge : {VertexPair{0, 1}, VertexPair{6, 7}}) {
    const std::string name = "an octahedron inside a tetrahedron 1000 times as large";
    add_operations(
        maker, "stress", "split the edge " + edge_text(edge) + " of " + name,
        {name, mesh, Anchoring::kOnEdge, {{OperationKind::kSplit, edge.first, edge.second}}});
  }
}

void add_boundary_cases(CaseMaker& maker) {
  for (const char* group : {"boundary", "boundary_split"}) {
    for (const char* file :
         {"two_triangles.obj", "single_triangle.obj", "grid_4x4.obj", "cylinder.dae"}) {
      add_every_edge(maker, group, OperationKind::kSplit, file, EdgeChoice::kBoundary);
    }
  }
  Random at_boundary = maker.random("boundary sequences");
  for (const char* file : {"two_triangles.obj", "single_triangle.obj", "grid_4x4.obj"}) {
    add_split_sequence(maker, "boundary_split", file, 6, at_boundary);
  }
  for (const char* file : {"single_triangle.obj", "fan.obj"}) {
    add_every_edge_elsewhere(maker, "boundary_split", OperationKind::kSplit, file,
                             EdgeChoice::kBoundary);
  }
  add_more_boundary_splits(maker, "boundary_split", at_boundary);
}

}  // namespace

void make_edge_split_cases(CaseMaker& maker) {
  for (const char* file : {"two_triangles.obj", "tetrahedron.obj", "octahedron.off", "cube.obj",
                           "icosahedron.obj", "grid_4x4.obj", "sliver.obj"}) {
    add_every_edge(maker, "basic", OperationKind::kSplit, file, EdgeChoice::kInner);
  }
  add_boundary_cases(maker);
  Random random = maker.random("sequences");
  for (const char* file : {"tetrahedron.obj", "octahedron.off", "cube_crossed.obj",
                           "valence_zoo.obj", "grid_4x4.obj", "two_components.obj"}) {
    add_sequence(maker, "stress", file, 8, 0, random);
  }
  for (const char* file : {"octahedron.off", "icosahedron.obj", "torus.ply"}) {
    add_sequence(maker, "stress", file, 12, 5, random);
  }
  for (const char* file : {"two_triangles.obj", "fan.obj", "umbrella.obj"}) {
    add_every_edge_elsewhere(maker, "stress", OperationKind::kSplit, file, EdgeChoice::kInner);
  }
  Random moved = maker.random("moved");
  add_sequence(maker, "stress", "double_torus.obj", 8, 0, moved);
  add_fresh_sequences(maker, "stress", OperationKind::kSplit, "icosahedron.obj", 8, moved);
  add_moved_sequences(maker, "stress", OperationKind::kSplit,
                      {"octahedron.off", "cube_crossed.obj", "icosahedron.obj", "grid_4x4.obj"},
                      moved);
  add_two_sizes(maker, moved);
  add_high_valences(maker, "stress", OperationKind::kSplit, moved);
  add_large_sequence(maker, "stress", OperationKind::kSplit, moved);
  add_constant_work(maker, "stress", OperationKind::kSplit, 50);
}

void shrink_edge_split_case(CaseMaker& maker, const Case& failed) {
  if (failed.group == "stress") add_smaller_operations(maker, failed);
}

}  // namespace meshgrade
