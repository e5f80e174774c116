#include "grader/cases/operation_cases.h"

#include <algorithm>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

std::string sequence_text(std::uint32_t length, std::uint32_t flips_of_ten) {
  const std::string count = std::to_string(length);
  if (flips_of_ten == 10) return count + " random flips of ";
  if (flips_of_ten == 0) return count + " random splits of ";
  return count + " random splits and flips of ";
}

std::vector<VertexPair> chosen_edges(const PolygonMesh& mesh, EdgeChoice choice) {
  const TriangleSet triangles(mesh);
  std::vector<VertexPair> edges = triangles.edges();
  std::erase_if(edges, [&](const VertexPair& edge) {
    return triangles.is_boundary(edge) != (choice == EdgeChoice::kBoundary);
  });
  return edges;
}

std::string edge_title(OperationKind kind, VertexPair edge, const std::string& file,
                       EdgeChoice choice) {
  const char* place = choice == EdgeChoice::kBoundary ? " the boundary edge " : " the edge ";
  return verb(kind) + std::string(place) + edge_text(edge) + " of " + file;
}

const char* function_of(OperationKind kind) {
  return kind == OperationKind::kFlip ? "HalfedgeMesh::flipEdge" : "HalfedgeMesh::splitEdge";
}

/// In a sequence of both, the split is what the case is about.
std::vector<std::string> called_by(const std::vector<Operation>& operations) {
  std::vector<std::string> calls;
  for (OperationKind kind : {OperationKind::kSplit, OperationKind::kFlip}) {
    if (std::any_of(operations.begin(), operations.end(),
                    [&](const Operation& operation) { return operation.kind == kind; })) {
      calls.emplace_back(function_of(kind));
    }
  }
  return calls;
}

}  // namespace

const char* verb(OperationKind kind) {
  return kind == OperationKind::kFlip ? "flip" : "split";
}

std::string edge_text(VertexPair edge) {
  return "v" + std::to_string(edge.first) + "-v" + std::to_string(edge.second);
}

void add_operations(CaseMaker& maker, const std::string& group, const std::string& title,
                    const OperationsInput& input) {
  const std::uint64_t budget =
      input.operations.size() * (2000 + 100 * input.mesh.polygons.size());
  maker.add(group, title, budget, input, called_by(input.operations));
}

void add_every_edge(CaseMaker& maker, const std::string& group, OperationKind kind,
                    const std::string& file, EdgeChoice choice) {
  const PolygonMesh mesh = maker.mesh(file);
  for (const VertexPair& edge : chosen_edges(mesh, choice)) {
    const std::vector<Operation> operations{{kind, edge.first, edge.second}};
    const std::string title = edge_title(kind, edge, file, choice);
    add_operations(maker, group, title, {file, mesh, Anchoring::kAsBuilt, operations});
    const char* anchored = choice == EdgeChoice::kBoundary
                               ? ", whose half-edge is the one outside"
                               : ", which its ends and faces anchor";
    add_operations(maker, group, title + anchored,
                   {file, mesh, Anchoring::kOnEdge, operations});
  }
}

void add_every_edge_elsewhere(CaseMaker& maker, const std::string& group, OperationKind kind,
                              const std::string& file, EdgeChoice choice) {
  const PolygonMesh mesh = maker.mesh(file);
  for (const VertexPair& edge : chosen_edges(mesh, choice)) {
    add_operations(maker, group,
                   edge_title(kind, edge, file, choice) + anchoring_text(Anchoring::kElsewhere),
                   {file, mesh, Anchoring::kElsewhere, {{kind, edge.first, edge.second}}});
  }
}

void add_split_sequence(CaseMaker& maker, const std::string& group, const std::string& file,
                        std::uint32_t length, Random& random) {
  const PolygonMesh mesh = maker.mesh(file);
  TriangleSet triangles(mesh);
  std::vector<Operation> operations;
  while (operations.size() < length) {
    const std::vector<VertexPair> edges = triangles.edges();
    const VertexPair edge = edges[random.below(static_cast<std::uint32_t>(edges.size()))];
    const bool at_boundary = operations.size() % 3 != 2;
    if (triangles.is_boundary(edge) != at_boundary) continue;
    operations.push_back({OperationKind::kSplit, edge.first, edge.second});
    triangles.split(edge);
  }
  add_operations(
      maker, group,
      std::to_string(length) + " random splits of " + file + ", inside and at its boundary",
      {file, mesh, Anchoring::kAsBuilt, operations});
}

void add_sequence(CaseMaker& maker, const std::string& group, const std::string& file,
                  std::uint32_t length, std::uint32_t flips_of_ten, Random& random) {
  const PolygonMesh mesh = maker.mesh(file);
  TriangleSet triangles(mesh);
  std::vector<Operation> operations;
  while (operations.size() < length) {
    const std::vector<VertexPair> edges = triangles.edges();
    const VertexPair edge = edges[random.below(static_cast<std::uint32_t>(edges.size()))];
    const bool flip = random.below(10) < flips_of_ten;
    if (flip ? !triangles.can_flip(edge) : triangles.is_boundary(edge)) continue;
    operations.push_back(
        {flip ? OperationKind::kFlip : OperationKind::kSplit, edge.first, edge.second});
    if (flip) {
      triangles.flip(edge);
    } else {
      triangles.split(edge);
    }
  }
  add_operations(maker, group, sequence_text(length, flips_of_ten) + file,
                 {file, mesh, Anchoring::kAsBuilt, operations});
}

}  // namespace meshgrade
