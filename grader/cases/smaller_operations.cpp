#include "grader/cases/smaller_operations.h"

#include <optional>

#include "grader/base/text.h"
#include "grader/cases/mesh_ladder.h"

namespace meshgrade {
namespace {

using Operations = std::vector<Operation>;

constexpr int kDraws = 60;  ///< sequences that are tried on a smaller mesh
constexpr std::size_t kMostInTitle = 6;

std::string title(const OperationsInput& input) {
  std::vector<std::string> parts;
  for (const Operation& operation : input.operations) {
    if (parts.size() == kMostInTitle) {
      parts.emplace_back("...");
      break;
    }
    parts.push_back(verb(operation.kind) + std::string(" ") +
                    edge_text({operation.a, operation.b}));
  }
  return join(parts, ", then ") + " of " + input.mesh_name + anchoring_text(input.anchoring);
}

void add_smaller(CaseMaker& maker, const Case& failed, const OperationsInput& input) {
  add_operations(maker, failed.group, title(input), input);
}

bool is_legal(const TriangleSet& triangles, const Operation& operation) {
  const VertexPair edge{operation.a, operation.b};
  if (!triangles.has_edge(edge.first, edge.second) &&
      !triangles.has_edge(edge.second, edge.first)) {
    return false;
  }
  if (triangles.is_boundary(edge)) return false;
  return operation.kind == OperationKind::kSplit || triangles.can_flip(edge);
}

void apply(TriangleSet& triangles, const Operation& operation) {
  const VertexPair edge{operation.a, operation.b};
  if (operation.kind == OperationKind::kFlip) {
    triangles.flip(edge);
  } else {
    triangles.split(edge);
  }
}

bool are_legal(const PolygonMesh& mesh, const Operations& operations) {
  TriangleSet triangles(mesh);
  for (const Operation& operation : operations) {
    if (!is_legal(triangles, operation)) return false;
    apply(triangles, operation);
  }
  return true;
}

/// The sequence without one operation. When that was a split, its vertex is missing from then
/// on, and later ones move up.
/// @return nothing if the rest is impossible
std::optional<Operations> without(const PolygonMesh& mesh, Operations operations,
                                  std::size_t left_out) {
  const Operation gone = operations[left_out];
  auto missing = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < left_out; ++i)
    missing += operations[i].kind == OperationKind::kSplit ? 1 : 0;
  operations.erase(operations.begin() + static_cast<std::ptrdiff_t>(left_out));
  if (gone.kind == OperationKind::kSplit) {
    for (std::size_t i = left_out; i < operations.size(); ++i) {
      for (std::uint32_t* end : {&operations[i].a, &operations[i].b}) {
        if (*end == missing) return std::nullopt;
        if (*end > missing) --*end;
      }
    }
  }
  if (!are_legal(mesh, operations)) return std::nullopt;
  return operations;
}

void add_fewer(CaseMaker& maker, const Case& failed, const OperationsInput& input) {
  for (std::size_t length = 1; length < input.operations.size(); ++length) {
    OperationsInput beginning = input;
    beginning.operations.resize(length);
    add_smaller(maker, failed, beginning);
  }
  for (std::size_t i = 0; i < input.operations.size(); ++i) {
    if (auto rest = without(input.mesh, input.operations, i); rest && !rest->empty()) {
      add_smaller(maker, failed, {input.mesh_name, input.mesh, input.anchoring, *rest});
    }
  }
}

/// Operations of the same kinds, in the same order, on edges drawn at random.
std::optional<Operations> draw(const PolygonMesh& mesh, const Operations& like,
                               Random& random) {
  TriangleSet triangles(mesh);
  Operations drawn;
  for (const Operation& operation : like) {
    Operations possible;
    for (const VertexPair& edge : triangles.edges()) {
      const Operation candidate{operation.kind, edge.first, edge.second};
      if (is_legal(triangles, candidate)) possible.push_back(candidate);
    }
    if (possible.empty()) return std::nullopt;
    drawn.push_back(possible[random.below(static_cast<std::uint32_t>(possible.size()))]);
    apply(triangles, drawn.back());
  }
  return drawn;
}

void add_on_smaller_meshes(CaseMaker& maker, const Case& failed, const OperationsInput& input) {
  for (const Rung& rung : smaller_meshes(maker, input.mesh)) {
    Random random = maker.random("smaller/" + rung.file);
    for (int i = 0; i < kDraws; ++i) {
      const auto drawn = draw(rung.mesh, input.operations, random);
      if (!drawn) break;
      add_smaller(maker, failed, {rung.file, rung.mesh, input.anchoring, *drawn});
    }
  }
}

}  // namespace

void add_smaller_operations(CaseMaker& maker, const Case& failed) {
  const auto input = from_wire<OperationsInput>(failed.input);
  if (!are_legal(input.mesh, input.operations)) return;
  add_fewer(maker, failed, input);
  add_on_smaller_meshes(maker, failed, input);
}

}  // namespace meshgrade
