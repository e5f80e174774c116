#include <gtest/gtest.h>

#include <vector>

#include "faults.h"
#include "meshedit/detail/inspector.h"
#include "meshedit/meshedit.h"

namespace meshedit {
namespace {

// Elements lie in chunks of 16, 32, 64, ...: the borders are at 16, 48, 112.
const std::vector<Index> kSizes = {0, 1, 2, 15, 16, 17, 47, 48, 49, 111, 112, 113, 500};

std::vector<VertexIter> append(HalfedgeMesh& mesh, Index count) {
  std::vector<VertexIter> vertices;
  for (Index i = 0; i < count; ++i) {
    vertices.push_back(mesh.newVertex());
    vertices.back()->position = static_cast<double>(i);
  }
  return vertices;
}

std::vector<double> forward(HalfedgeMesh& mesh) {
  std::vector<double> values;
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    values.push_back(v->position.x);
  }
  return values;
}

std::vector<double> backward(HalfedgeMesh& mesh) {
  std::vector<double> values;
  for (VertexIter v = mesh.verticesEnd(); v != mesh.verticesBegin();) {
    --v;
    values.insert(values.begin(), v->position.x);
  }
  return values;
}

/// 0, 1, ..., count - 1 without those that `leave_out` holds for.
template <class LeaveOut>
std::vector<double> numbers(Index count, LeaveOut leave_out) {
  std::vector<double> values;
  for (Index i = 0; i < count; ++i) {
    if (!leave_out(i)) values.push_back(static_cast<double>(i));
  }
  return values;
}

class Pool : public FaultTest {};

TEST_F(Pool, WalksMeetEveryElementInOrderAtEverySize) {
  for (const Index size : kSizes) {
    HalfedgeMesh mesh;
    append(mesh, size);
    const std::vector<double> expected = numbers(size, [](Index) { return false; });
    EXPECT_EQ(mesh.nVertices(), size);
    EXPECT_EQ(forward(mesh), expected) << size;
    EXPECT_EQ(backward(mesh), expected) << size;
  }
}

TEST_F(Pool, WalksPassOverDeletedElements) {
  const auto every_third = [](Index i) { return i % 3 == 0; };
  const auto ends = [](Index i) { return i < 5 || i > 40; };
  const auto borders = [](Index i) { return i % 16 == 15 || i % 16 == 0; };
  const auto all = [](Index) { return true; };
  const auto check = [](Index size, auto deleted) {
    HalfedgeMesh mesh;
    const std::vector<VertexIter> vertices = append(mesh, size);
    for (Index i = 0; i < size; ++i) {
      if (deleted(i)) mesh.deleteVertex(vertices[i]);
    }
    const std::vector<double> expected = numbers(size, deleted);
    EXPECT_EQ(mesh.nVertices(), expected.size());
    EXPECT_EQ(forward(mesh), expected) << size;
    EXPECT_EQ(backward(mesh), expected) << size;
  };
  for (const Index size : kSizes) {
    check(size, every_third);
    check(size, ends);
    check(size, borders);
    check(size, all);
  }
}

TEST_F(Pool, ElementsNeverMove) {
  HalfedgeMesh mesh;
  const VertexIter first = mesh.newVertex();
  const void* address = elementAddress(first);
  const std::vector<VertexIter> others = append(mesh, 1000);
  for (Index i = 0; i < others.size(); i += 2) {
    mesh.deleteVertex(others[i]);
  }
  append(mesh, 1000);
  EXPECT_EQ(elementAddress(mesh.verticesBegin()), address);
  EXPECT_EQ(fault_of([&] { first->position = 7; }), "");
  for (Index i = 1; i < others.size(); i += 2) {
    EXPECT_EQ(others[i]->position.x, static_cast<double>(i));
  }
}

TEST_F(Pool, StoredEndStaysTheEnd) {
  HalfedgeMesh mesh;
  const VertexIter end = mesh.verticesEnd();
  EXPECT_TRUE(mesh.verticesBegin() == end);
  for (int i = 0; i < 200; ++i) {
    mesh.newVertex();
    EXPECT_TRUE(mesh.verticesEnd() == end);
  }
  while (mesh.nVertices() != 0) {
    mesh.deleteVertex(mesh.verticesBegin());
  }
  EXPECT_TRUE(mesh.verticesBegin() == end);
}

TEST_F(Pool, RunningLoopMeetsWhatIsAppended) {
  HalfedgeMesh mesh;
  mesh.newVertex();
  Index met = 0;
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    ++met;
    if (mesh.nVertices() < 300) mesh.newVertex();
  }
  EXPECT_EQ(met, 300U);
}

TEST_F(Pool, RunningLoopMayDeleteBehindItself) {
  HalfedgeMesh mesh;
  append(mesh, 120);
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd();) {
    const VertexIter old = v++;
    if (static_cast<int>(old->position.x) % 2 == 0) mesh.deleteVertex(old);
  }
  EXPECT_EQ(forward(mesh), numbers(120, [](Index i) { return i % 2 == 0; }));
}

TEST_F(Pool, FindsElementsByAddressAndNothingElse) {
  for (const Index size : kSizes) {
    HalfedgeMesh mesh;
    append(mesh, size);
    const auto& pool = detail::Inspector::vertices(mesh);
    for (Index i = 0; i < size; ++i) {
      EXPECT_EQ(pool.find(pool.at(i)), static_cast<std::ptrdiff_t>(i));
      EXPECT_EQ(pool.find(reinterpret_cast<const char*>(pool.at(i)) + 1), -1);
    }
    EXPECT_EQ(pool.find(nullptr), -1);
    EXPECT_EQ(pool.find(&mesh), -1);
    EXPECT_EQ(pool.find(elementAddress(mesh.verticesEnd())), -1);
    EXPECT_TRUE(pool.is_end(elementAddress(mesh.verticesEnd())));
  }
}

}  // namespace
}  // namespace meshedit
