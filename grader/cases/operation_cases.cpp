#include "grader/cases/operation_cases.h"

#include <algorithm>
#include <set>

#include "grader/base/text.h"
#include "grader/cases/moved_meshes.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/torus_mesh.h"

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

/// How many of ten operations are flips, where all are of one kind.
std::uint32_t flips(OperationKind kind) {
  return kind == OperationKind::kFlip ? 10 : 0;
}

/// Each operation the next way to anchor, beginning with `first`.
std::vector<Operation> anchored(std::vector<Operation> operations, std::uint32_t first = 0) {
  for (std::size_t i = 0; i < operations.size(); ++i)
    operations[i].anchors = (first + static_cast<std::uint32_t>(i)) % kAnchorWays;
  return operations;
}

/// The same at a boundary, where two of three operations count: these have all ways in turn.
std::vector<Operation> anchored_at_boundary(std::vector<Operation> operations) {
  for (std::size_t i = 0; i < operations.size(); ++i)
    operations[i].anchors = static_cast<std::uint32_t>(i - i / 3) % kAnchorWays;
  return operations;
}

std::uint64_t operations_budget(const OperationsInput& input) {
  return input.operations.size() * (2000 + 100 * input.mesh.polygons.size());
}

/// Random operations on inner edges, each with a single right outcome: flips double no edge.
/// They begin with `operations`, and there are `length` in all.
std::vector<Operation> draw_operations(const PolygonMesh& mesh,
                                       std::vector<Operation> operations, std::uint32_t length,
                                       std::uint32_t flips_of_ten, Random& random) {
  TriangleSet triangles(mesh);
  const auto apply = [&](const Operation& operation) {
    const VertexPair edge{operation.a, operation.b};
    if (operation.kind == OperationKind::kFlip) {
      triangles.flip(edge);
    } else {
      triangles.split(edge);
    }
  };
  std::for_each(operations.begin(), operations.end(), apply);
  while (operations.size() < length) {
    const std::vector<VertexPair> edges = triangles.edges();
    const VertexPair edge = edges[random.below(static_cast<std::uint32_t>(edges.size()))];
    const bool flip = random.below(10) < flips_of_ten;
    if (flip ? !triangles.can_flip(edge) : triangles.is_boundary(edge)) continue;
    operations.push_back(
        {flip ? OperationKind::kFlip : OperationKind::kSplit, edge.first, edge.second});
    apply(operations.back());
  }
  return operations;
}

/// For draw_boundary_splits(): all are at the boundary.
constexpr std::size_t kNoneInside = 3;

/// Random splits that begin with `operations`. Two of three are at the boundary, and the one
/// with the place `inside` among the three is not.
std::vector<Operation> draw_boundary_splits(const PolygonMesh& mesh,
                                            std::vector<Operation> operations,
                                            std::uint32_t length, Random& random,
                                            std::size_t inside = 2) {
  TriangleSet triangles(mesh);
  for (const Operation& operation : operations)
    triangles.split({operation.a, operation.b});
  while (operations.size() < length) {
    const std::vector<VertexPair> edges = triangles.edges();
    const VertexPair edge = edges[random.below(static_cast<std::uint32_t>(edges.size()))];
    const bool at_boundary = operations.size() % 3 != inside;
    if (triangles.is_boundary(edge) != at_boundary) continue;
    operations.push_back({OperationKind::kSplit, edge.first, edge.second});
    triangles.split(edge);
  }
  return operations;
}

/// Splits both boundary edges at the vertex in the middle of a fan, with each way to anchor
/// them.
void add_splits_at_hub(CaseMaker& maker, const std::string& group, const PolygonMesh& fan) {
  const auto last = static_cast<std::uint32_t>(fan.positions.size() - 1);
  for (std::uint32_t way = 0; way < kAnchorWays; ++way) {
    add_operations(
        maker, group,
        "split both boundary edges at the vertex in the middle of a fan of 22 "
        "triangles (" +
            std::to_string(way + 1) + ")",
        {"a fan of 22 triangles",
         fan,
         Anchoring::kOnEachEdge,
         {{OperationKind::kSplit, 0, 1, way}, {OperationKind::kSplit, 0, last, way}}});
  }
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
  maker.add(group, title, operations_budget(input), input, called_by(input.operations));
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
  add_operations(
      maker, group,
      std::to_string(length) + " random splits of " + file + ", inside and at its boundary",
      {file, mesh, Anchoring::kAsBuilt, draw_boundary_splits(mesh, {}, length, random)});
}

void add_more_boundary_splits(CaseMaker& maker, const std::string& group, Random& random) {
  // Two of three are at the boundary: so many that each way to anchor is among them.
  constexpr std::uint32_t kLength = 8;
  const std::string title = std::to_string(kLength) + " random splits of ";
  const auto add = [&](const std::string& name, const PolygonMesh& mesh,
                       const std::vector<Operation>& first) {
    add_operations(maker, group, title + name + ", inside and at its boundary",
                   {name, mesh, Anchoring::kOnEachEdge,
                    anchored_at_boundary(draw_boundary_splits(mesh, first, kLength, random))});
  };
  const PolygonMesh fan = shaken(maker.mesh("fan.obj"), random);
  const std::vector<Operation> first = draw_boundary_splits(fan, {}, 1, random);
  for (const MovedMesh& moved : moved_meshes(fan, {first[0].a, first[0].b})) {
    add("fan.obj, shaken, " + moved.how, moved.mesh,
        {{OperationKind::kSplit, moved.edge.first, moved.edge.second}});
  }
  const PolygonMesh wide = open_fan(22);
  add("a fan of 22 triangles", wide, {{OperationKind::kSplit, 0, 1}});
  add_splits_at_hub(maker, group, wide);
  const PolygonMesh large = open_grid(16, random);
  add("a square of 512 triangles", large, {});
  const PolygonMesh grid = shaken(maker.mesh("grid_4x4.obj"), random);
  // A mistake at the third call only: that is at the boundary, once for each way to anchor. The
  // third call of a helper may be in the second split.
  for (const std::size_t inside : {std::size_t{1}, kNoneInside}) {
    for (std::uint32_t way = 0; way < kAnchorWays; ++way) {
      const OperationsInput input{
          "grid_4x4.obj, shaken", grid, Anchoring::kOnEachEdge,
          anchored(draw_boundary_splits(grid, {}, 3, random, inside), way)};
      maker.add_fresh(group,
                      std::string("3 random splits of grid_4x4.obj, shaken, ") +
                          (inside == kNoneInside ? "" : "inside and ") +
                          "at its boundary, before anything else (" + std::to_string(way + 1) +
                          ")",
                      operations_budget(input), input, called_by(input.operations));
    }
  }
}

void add_sequence(CaseMaker& maker, const std::string& group, const std::string& file,
                  std::uint32_t length, std::uint32_t flips_of_ten, Random& random) {
  const PolygonMesh mesh = maker.mesh(file);
  add_operations(maker, group, sequence_text(length, flips_of_ten) + file,
                 {file, mesh, Anchoring::kAsBuilt,
                  draw_operations(mesh, {}, length, flips_of_ten, random)});
}

void add_moved_sequences(CaseMaker& maker, const std::string& group, OperationKind kind,
                         const std::vector<std::string>& files, Random& random) {
  const std::string& file = files[random.below(static_cast<std::uint32_t>(files.size()))];
  const PolygonMesh mesh = shaken(maker.mesh(file), random);
  const std::vector<Operation> first = draw_operations(mesh, {}, 1, flips(kind), random);
  const VertexPair edge{first[0].a, first[0].b};
  for (const MovedMesh& moved : moved_meshes(mesh, edge)) {
    const std::string name = file + ", shaken, " + moved.how;
    const std::vector<Operation> operations =
        draw_operations(moved.mesh, {{kind, moved.edge.first, moved.edge.second}}, kAnchorWays,
                        flips(kind), random);
    add_operations(maker, group, sequence_text(kAnchorWays, flips(kind)) + name,
                   {name, moved.mesh, Anchoring::kOnEachEdge, anchored(operations)});
  }
}

void add_high_valences(CaseMaker& maker, const std::string& group, OperationKind kind,
                       Random& random) {
  const PolygonMesh mesh = many_valences(13, 24, random);
  std::vector<std::uint32_t> valence(mesh.positions.size(), 0);
  for (const auto& triangle : mesh.polygons) {
    for (std::uint32_t corner : triangle)
      ++valence[corner];
  }
  // Of each vertex one edge whose half-edge starts there, as it is built, and one whose
  // half-edge does so when it is turned: both begin at the vertex then.
  std::set<std::uint32_t> done;
  std::vector<Operation> operations;
  for (std::uint32_t v = 0; v < valence.size(); ++v) {
    if (valence[v] < 13 || !done.insert(valence[v]).second) continue;
    const auto way = static_cast<std::uint32_t>(done.size()) % 3;
    for (const auto& triangle : mesh.polygons) {
      const auto corner = std::find(triangle.begin(), triangle.end(), v);
      if (corner == triangle.end()) continue;
      const std::uint32_t next = corner + 1 == triangle.end() ? triangle[0] : corner[1];
      const std::uint32_t last = corner == triangle.begin() ? triangle.back() : corner[-1];
      operations.push_back({kind, std::min(v, next), std::max(v, next), way + 3});
      operations.push_back({kind, std::min(v, last), std::max(v, last), way});
      break;
    }
  }
  add_operations(maker, group,
                 std::to_string(operations.size()) + " " + verb(kind) +
                     "s at vertices with 13 to 24 neighbours",
                 {"double pyramids", mesh, Anchoring::kOnEachEdge, operations});
}

void add_constant_work(CaseMaker& maker, const std::string& group, OperationKind kind,
                       std::uint32_t n) {
  const std::string count = std::to_string(2 * n * n) + " triangles";
  maker.add(group,
            std::string(verb(kind)) + " one edge of a mesh of " + count + ": constant work",
            5000,
            OperationsInput{"the mesh of " + count,
                            in_build_order(torus_mesh(n, n)),
                            Anchoring::kOnEdge,
                            {{kind, 0, 1}}});
}

void add_large_sequence(CaseMaker& maker, const std::string& group, OperationKind kind,
                        Random& random) {
  const PolygonMesh mesh = in_build_order(torus_mesh(24, 24));
  add_operations(maker, group,
                 sequence_text(kAnchorWays, flips(kind)) + "a torus of 1152 triangles",
                 {"a torus of 1152 triangles", mesh, Anchoring::kOnEachEdge,
                  anchored(draw_operations(mesh, {}, kAnchorWays, flips(kind), random))});
}

void add_fresh_sequences(CaseMaker& maker, const std::string& group, OperationKind kind,
                         const std::string& file, std::uint32_t length, Random& random) {
  const PolygonMesh mesh = shaken(maker.mesh(file), random);
  for (std::uint32_t way = 0; way < kAnchorWays; ++way) {
    const OperationsInput input{
        file + ", shaken", mesh, Anchoring::kOnEachEdge,
        anchored(draw_operations(mesh, {}, length, flips(kind), random), way)};
    maker.add_fresh(group,
                    sequence_text(length, flips(kind)) + file +
                        ", shaken, before anything else (" + std::to_string(way + 1) + ")",
                    operations_budget(input), input, called_by(input.operations));
  }
}

}  // namespace meshgrade
