#include "grader/cases/own_meshes.h"

#include <algorithm>
#include <map>
#include <set>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/cases/mesh_input.h"
#include "grader/cases/mesh_shapes.h"
#include "grader/cases/operation_cases.h"
#include "grader/files/mesh_file.h"
#include "grader/mesh/build_mesh.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostEdges = 500;          // each is a case or two
constexpr std::size_t kMostTriangles = 200'000;  // after subdivision

[[noreturn]] void fail(const OwnMesh& own, const std::string& what) {
  throw UserError(own.place + ": " + own.name + " " + what);
}

/// A mesh with the numbers of its vertices in build order by those in the file.
struct ReadMesh {
  PolygonMesh mesh;
  std::map<std::uint32_t, std::uint32_t> numbers;
};

ReadMesh read(const OwnMesh& own) {
  PolygonMesh polygons;
  try {
    polygons = read_mesh(own.file).mesh;
  } catch (const UserError& error) {
    fail(own, std::string("cannot be read: ") + error.what());
  }
  ReadMesh result;
  for (std::size_t f = 0; f < polygons.polygons.size(); ++f) {
    if (polygons.polygons[f].size() != 3) {
      fail(own, "must be of triangles: its face " + std::to_string(f) + " has " +
                    plural(polygons.polygons[f].size(), "corner"));
    }
    for (const std::uint32_t v : polygons.polygons[f])
      result.numbers.emplace(v, static_cast<std::uint32_t>(result.numbers.size()));
  }
  result.mesh = in_build_order(polygons);
  try {
    meshedit::HalfedgeMesh mesh;
    build_mesh(result.mesh, mesh);
  } catch (const meshedit::MeshError& error) {
    fail(own, std::string("is no surface: half-edges cannot be made of it: ") + error.what());
  }
  return result;
}

/// The edges to ask for, by their ends in build order.
std::vector<VertexPair> edges_of(const OwnMesh& own, const ReadMesh& read) {
  const TriangleSet triangles(read.mesh);
  const EdgesOf which = own.edges.value_or(EdgesOf::kInner);
  std::vector<VertexPair> edges;
  if (which == EdgesOf::kNamed) {
    for (const auto& [a, b] : own.named_edges) {
      const auto first = read.numbers.find(a);
      const auto second = read.numbers.find(b);
      const bool known = first != read.numbers.end() && second != read.numbers.end();
      if (!known || !(triangles.has_edge(first->second, second->second) ||
                      triangles.has_edge(second->second, first->second))) {
        fail(own, "has no edge between its vertices " + std::to_string(a) + " and " +
                      std::to_string(b) + " (counted from 0)");
      }
      edges.push_back(std::minmax(first->second, second->second));
    }
    return edges;
  }
  edges = triangles.edges();
  std::erase_if(edges, [&](const VertexPair& edge) {
    return which != EdgesOf::kEvery &&
           triangles.is_boundary(edge) != (which == EdgesOf::kBoundary);
  });
  if (edges.empty()) fail(own, "has no such edges");
  if (edges.size() > kMostEdges) {
    fail(own, "has " + std::to_string(edges.size()) + " such edges, more than " +
                  std::to_string(kMostEdges) + ": name the ones to try, as edges = [[0, 1]]");
  }
  return edges;
}

void add_edges(CaseMaker& maker, const std::string& group, OperationKind kind,
               const OwnMesh& own) {
  const ReadMesh mesh = read(own);
  for (const VertexPair& edge : edges_of(own, mesh)) {
    const std::string title =
        std::string(verb(kind)) + " the edge " + edge_text(edge) + " of " + own.name;
    for (const Anchoring anchoring : {Anchoring::kAsBuilt, Anchoring::kElsewhere}) {
      add_operations(maker, group, title + anchoring_text(anchoring),
                     {own.name, mesh.mesh, anchoring, {{kind, edge.first, edge.second}}});
    }
  }
}

void add_flips(CaseMaker& maker, const std::string& group, const OwnMesh& own) {
  add_edges(maker, group, OperationKind::kFlip, own);
}

void add_splits(CaseMaker& maker, const std::string& group, const OwnMesh& own) {
  add_edges(maker, group, OperationKind::kSplit, own);
}

void add_normals(CaseMaker& maker, const std::string& group, const OwnMesh& own) {
  const ReadMesh mesh = read(own);
  maker.add(group, "the normals of " + own.name, 1000 + 400 * mesh.mesh.polygons.size(),
            NormalInput{mesh.mesh, Anchoring::kAsBuilt});
}

void add_levels(CaseMaker& maker, const std::string& group, const OwnMesh& own) {
  const ReadMesh mesh = read(own);
  const std::uint32_t levels = std::max<std::uint32_t>(1, own.levels);
  const std::uint64_t triangles = mesh.mesh.polygons.size() << (2U * levels);
  if (triangles > kMostTriangles) {
    fail(own, "would have " + std::to_string(triangles) + " triangles after " +
                  plural(levels, "level") + ", more than " + std::to_string(kMostTriangles));
  }
  maker.add(group, plural(levels, "level") + " on " + own.name, 10'000 + 1000 * triangles,
            SubdivisionInput{own.name, mesh.mesh, levels, Anchoring::kAsBuilt});
}

/// What an exercise does with a mesh, and what may be said of it.
struct Use {
  void (*add)(CaseMaker&, const std::string& group, const OwnMesh&);
  bool takes_edges;
  bool takes_levels;
};

const Use& use_in(const ExerciseRubric& rubric, const OwnMesh& own) {
  static const std::map<std::string, Use> uses{{"vertex_normal", {add_normals, false, false}},
                                               {"edge_flip", {add_flips, true, false}},
                                               {"edge_split", {add_splits, true, false}},
                                               {"loop_subdivision", {add_levels, false, true}}};
  const auto use = uses.find(rubric.name);
  if (use == uses.end()) {
    throw UserError(own.place + ": " + rubric.name + " has no use for a mesh");
  }
  const auto refuse = [&](const char* key) {
    throw UserError(own.place + ": " + rubric.name + " has no use for the key " + key);
  };
  if (own.edges && !use->second.takes_edges) refuse("edges");
  if (own.levels != 0 && !use->second.takes_levels) refuse("levels");
  return use->second;
}

}  // namespace

void add_own_meshes(CaseMaker& maker, const ExerciseRubric& rubric, bool hidden) {
  for (const Group& group : rubric.groups) {
    for (const OwnMesh& own : group.meshes) {
      if (own.hidden == hidden && own.is_there) use_in(rubric, own).add(maker, group.name, own);
    }
  }
}

void check_own_meshes(const Assignment& assignment) {
  for (const ExerciseRubric& rubric : assignment.exercises) {
    for (const Group& group : rubric.groups) {
      for (const OwnMesh& own : group.meshes)
        use_in(rubric, own);
    }
    CaseMaker maker(assignment, rubric, "");
    for (const bool hidden : {false, true})
      add_own_meshes(maker, rubric, hidden);
  }
}

}  // namespace meshgrade
