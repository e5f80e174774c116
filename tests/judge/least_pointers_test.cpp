// The list of wrong pointers is the shortest one, over every right answer that there is.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "grader/base/random.h"
#include "grader/judge/operation_model.h"
#include "grader/judge/pointer_diff.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

/// A flip or split with a right answer.
struct Done {
  std::string file;
  MeshDump before;
  MeshDump right;
  Ref edge = kUnsetRef;
  Ref split_vertex = kUnsetRef;
};

std::vector<Done> operations_on(const std::string& file) {
  std::vector<Done> list;
  const MeshDump before = sample_dump(file);
  for (Ref e = 0; e < before.edges.size() && e < 7; ++e) {
    Done split{file, before, before, e, kUnsetRef};
    split.split_vertex = model_split(split.right, e);
    list.push_back(split);
    if (is_boundary_edge(before, e)) continue;
    const Diamond d = diamond_of(before, e);
    if (find_edge(before, d.a, d.d) != kUnsetRef) continue;
    Done flip{file, before, before, e, kUnsetRef};
    model_flip(flip.right, e);
    list.push_back(flip);
  }
  return list;
}

std::vector<Ref> random_order(std::vector<Ref> list, Random& random) {
  for (std::size_t i = list.size(); i > 1; --i)
    std::swap(list[i - 1], list[random.below(static_cast<std::uint32_t>(i))]);
  return list;
}

/// The half-edges in the triangles around the edge, and the new ones.
std::vector<Ref> inner_halfedges(const Done& done) {
  std::vector<Ref> list;
  const Ref h = done.before.edges[done.edge].halfedge;
  for (Ref side : {h, done.before.halfedges[h].twin}) {
    list.push_back(side);
    if ((done.before.halfedges[side].face & kBoundaryBit) != 0) continue;
    const Ref next = done.before.halfedges[side].next;
    list.push_back(next);
    list.push_back(done.before.halfedges[next].next);
  }
  for (Ref i = static_cast<Ref>(done.before.halfedges.size()); i < done.right.halfedges.size();
       ++i)
    list.push_back(i);
  return list;
}

/// The same answer by other half-edges: each of `players` plays the part of another one.
MeshDump with_other_players(const MeshDump& mesh, const std::vector<Ref>& players,
                            Random& random) {
  const std::vector<Ref> order = random_order(players, random);
  std::vector<Ref> plays(mesh.halfedges.size());
  std::iota(plays.begin(), plays.end(), Ref{0});
  for (std::size_t i = 0; i < players.size(); ++i)
    plays[players[i]] = order[i];
  MeshDump other = mesh;
  for (Ref h = 0; h < mesh.halfedges.size(); ++h) {
    HalfedgeRecord record = mesh.halfedges[h];
    record.next = plays[record.next];
    record.twin = plays[record.twin];
    other.halfedges[plays[h]] = record;
  }
  const auto turn = [&](auto& records) {
    for (auto& record : records)
      record.halfedge = plays[record.halfedge];
  };
  turn(other.vertices);
  turn(other.edges);
  turn(other.faces);
  turn(other.boundaries);
  return other;
}

/// One pointer of the neighbourhood, and how a finding calls it.
struct Cell {
  Ref* pointer;
  std::uint32_t targets;  ///< how many elements there are that it could lead to
  std::string name;
};

std::vector<Cell> cells_of(MeshDump& mesh, const std::vector<Ref>& halfedges) {
  const auto size = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
  std::vector<Cell> cells;
  for (Ref h : halfedges) {
    HalfedgeRecord& record = mesh.halfedges[h];
    cells.push_back({&record.next, size(mesh.halfedges), halfedge_name(h) + ".next"});
    cells.push_back({&record.twin, size(mesh.halfedges), halfedge_name(h) + ".twin"});
    cells.push_back({&record.vertex, size(mesh.vertices), halfedge_name(h) + ".vertex"});
    cells.push_back({&record.edge, size(mesh.edges), halfedge_name(h) + ".edge"});
    if ((record.face & kBoundaryBit) == 0)
      cells.push_back({&record.face, size(mesh.faces), halfedge_name(h) + ".face"});
  }
  for (Ref e = 0; e < mesh.edges.size(); ++e)
    cells.push_back(
        {&mesh.edges[e].halfedge, size(mesh.halfedges), edge_name(e) + ".halfedge"});
  return cells;
}

PointerDiff diff_of(const Done& done, const MeshDump& after) {
  return diff_pointers(done.before, after, done.right, done.edge, done.split_vertex);
}

const std::vector<std::string> kFiles{"octahedron.off",    "tetrahedron.obj", "grid_hole.off",
                                      "two_triangles.obj", "icosahedron.obj", "fan.obj"};

class LeastPointers : public testing::TestWithParam<std::string> {
 protected:
  Random random_{7, "least pointers"};
};

TEST_P(LeastPointers, NothingIsWrongHoweverTheHalfedgesTurn) {
  for (const Done& done : operations_on(GetParam())) {
    for (int i = 0; i < 8; ++i) {
      const MeshDump after = with_other_players(done.right, inner_halfedges(done), random_);
      EXPECT_EQ(diff_of(done, after).wrong.size(), 0U) << "edge " << done.edge;
    }
  }
}

// Two answers that differ in one pointer only can both be the nearest: then the other end of
// what disagrees is named.
TEST_P(LeastPointers, OneWrongPointerIsTheOnlyOneListed) {
  std::size_t tried = 0;
  std::size_t named = 0;
  for (const Done& done : operations_on(GetParam())) {
    for (int i = 0; i < 40; ++i) {
      const std::vector<Ref> inner = inner_halfedges(done);
      MeshDump after = with_other_players(done.right, inner, random_);
      std::vector<Cell> cells = cells_of(after, inner);
      const Cell& cell = cells[random_.below(static_cast<std::uint32_t>(cells.size()))];
      const Ref right = *cell.pointer;
      *cell.pointer = random_.below(4) == 0 ? kUnsetRef : random_.below(cell.targets);
      if (*cell.pointer == right) continue;
      const PointerDiff diff = diff_of(done, after);
      ASSERT_LE(diff.wrong.size(), 1U) << cell.name << ", edge " << done.edge;
      if (diff.wrong.empty()) continue;  // another anchor, as good
      ++tried;
      if (diff.wrong[0].name == cell.name) ++named;
    }
  }
  EXPECT_GE(100 * named, 98 * tried) << named << " of " << tried;
}

TEST_P(LeastPointers, SoManyWrongOnesAreListedAsWereChangedAtMost) {
  for (const Done& done : operations_on(GetParam())) {
    for (std::size_t changes = 2; changes < 8; ++changes) {
      const std::vector<Ref> inner = inner_halfedges(done);
      MeshDump after = with_other_players(done.right, inner, random_);
      std::vector<Cell> cells = cells_of(after, inner);
      for (std::size_t i = 0; i < changes; ++i) {
        const Cell& cell = cells[random_.below(static_cast<std::uint32_t>(cells.size()))];
        *cell.pointer = random_.below(cell.targets);
      }
      EXPECT_LE(diff_of(done, after).wrong.size(), changes) << "edge " << done.edge;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, LeastPointers, testing::ValuesIn(kFiles),
                         [](const auto& file) {
                           return file.param.substr(0, file.param.find('.'));
                         });

}  // namespace
}  // namespace meshgrade
