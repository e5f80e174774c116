#include "grader/cases/operation_cases.h"
#include "grader/cases/smaller_operations.h"

namespace meshgrade {
namespace {

/// Six flips of one edge bring its diamond back to where it began.
void add_six_flips(CaseMaker& maker, const std::string& file) {
  const PolygonMesh mesh = maker.mesh(file);
  TriangleSet triangles(mesh);
  VertexPair edge{0, 0};
  for (const VertexPair& candidate : triangles.edges()) {
    if (triangles.can_flip(candidate)) edge = candidate;
  }
  if (edge.first == edge.second) return;
  std::vector<Operation> flips;
  const std::string title = "six flips in a row of the edge " + edge_text(edge) + " of " + file;
  for (int i = 0; i < 6; ++i) {
    flips.push_back({OperationKind::kFlip, edge.first, edge.second});
    edge = triangles.flip(edge);
  }
  add_operations(maker, "stress", title, {file, mesh, Anchoring::kAsBuilt, flips});
}

}  // namespace

void make_edge_flip_cases(CaseMaker& maker) {
  for (const char* file : {"two_triangles.obj", "octahedron.off", "cube.obj", "icosahedron.obj",
                           "grid_4x4.obj", "fan.obj", "tetrahedron.obj"}) {
    add_every_edge(maker, "basic", OperationKind::kFlip, file, EdgeChoice::kInner);
  }
  for (const char* file :
       {"two_triangles.obj", "single_triangle.obj", "grid_4x4.obj", "cylinder.dae"}) {
    add_every_edge(maker, "boundary", OperationKind::kFlip, file, EdgeChoice::kBoundary);
  }
  for (const char* file : {"two_triangles.obj", "octahedron.off", "cube.obj"}) {
    add_six_flips(maker, file);
  }
  Random random = maker.random("sequences");
  for (const char* file : {"octahedron.off", "cube_crossed.obj", "icosahedron.obj", "torus.ply",
                           "valence_zoo.obj", "grid_4x4.obj", "double_torus.obj"}) {
    add_sequence(maker, "stress", file, 12, 10, random);
  }
  add_constant_work(maker, "stress", OperationKind::kFlip, 100);
  for (const char* file : {"two_triangles.obj", "fan.obj", "umbrella.obj"}) {
    add_every_edge_elsewhere(maker, "stress", OperationKind::kFlip, file, EdgeChoice::kInner);
  }
  Random moved = maker.random("moved");
  add_fresh_sequences(maker, "stress", OperationKind::kFlip, "icosahedron.obj", 8, moved);
  add_moved_sequences(maker, "stress", OperationKind::kFlip,
                      {"octahedron.off", "cube_crossed.obj", "icosahedron.obj", "grid_4x4.obj"},
                      moved);
  add_high_valences(maker, "stress", OperationKind::kFlip, moved);
  add_large_sequence(maker, "stress", OperationKind::kFlip, moved);
}

void shrink_edge_flip_case(CaseMaker& maker, const Case& failed) {
  if (failed.group == "stress") add_smaller_operations(maker, failed);
}

}  // namespace meshgrade
