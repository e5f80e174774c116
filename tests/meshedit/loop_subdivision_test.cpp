#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mesh_invariants.h"
#include "meshedit/meshedit.h"
#include "sample_meshes.h"

namespace meshedit {
namespace {

HalfedgeMesh subdivided(const Polygons& polygons, int times = 1) {
  HalfedgeMesh mesh = mesh_of(polygons);
  MeshResampler resampler;
  for (int i = 0; i < times; ++i) {
    resampler.upsample(mesh);
  }
  return mesh;
}

/// True if some vertex lies at p.
bool has_vertex_at(const HalfedgeMesh& mesh, const Vector3D& p) {
  for (VertexCIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    if ((v->position - p).norm() < 1e-13) return true;
  }
  return false;
}

TEST(LoopSubdivision, EveryTriangleBecomesFour) {
  for (const Polygons& polygons : all_triangle_meshes()) {
    HalfedgeMesh mesh = mesh_of(polygons);
    MeshResampler resampler;
    for (int level = 0; level < 3; ++level) {
      const HalfedgeMesh before = mesh;
      Size boundary_edges = 0;
      for (FaceCIter b = before.boundariesBegin(); b != before.boundariesEnd(); ++b) {
        boundary_edges += b->degree();
      }
      resampler.upsample(mesh);
      ASSERT_EQ(broken_rule(mesh), "");
      EXPECT_EQ(mesh.nFaces(), 4 * before.nFaces());
      EXPECT_EQ(mesh.nVertices(), before.nVertices() + before.nEdges());
      EXPECT_EQ(mesh.nEdges(), 2 * before.nEdges() + 3 * before.nFaces());
      EXPECT_EQ(mesh.nBoundaries(), before.nBoundaries());
      Size boundary_edges_now = 0;
      for (FaceIter b = mesh.boundariesBegin(); b != mesh.boundariesEnd(); ++b) {
        boundary_edges_now += b->degree();
      }
      EXPECT_EQ(boundary_edges_now, 2 * boundary_edges);
    }
  }
}

TEST(LoopSubdivision, OldVerticesKeepTheirDegreeAndNewOnesAreRegular) {
  for (const Polygons& polygons : all_triangle_meshes()) {
    HalfedgeMesh old = mesh_of(polygons);
    HalfedgeMesh mesh = subdivided(polygons);
    VertexIter w = old.verticesBegin();
    for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
      if (w != old.verticesEnd()) {
        EXPECT_EQ(v->degree(), w->degree());
        ++w;
      } else {
        EXPECT_EQ(v->degree(), v->isBoundary() ? 3U : 6U);
      }
    }
  }
}

// The four neighbours of a vertex cancel out: it goes to (1 - 4 * 3/32) = 5/8 of itself. The
// two vertices opposite an edge cancel out, too.
TEST(LoopSubdivision, OctahedronHasAClosedForm) {
  const HalfedgeMesh mesh = subdivided(octahedron());
  ASSERT_EQ(mesh.nVertices(), 18U);
  const std::vector<Vector3D> corners = octahedron().positions;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_TRUE(has_vertex_at(mesh, 5.0 / 8.0 * corners[i]));
    for (std::size_t j = 0; j < i; ++j) {
      const bool opposite = dot(corners[i], corners[j]) < 0.0;
      EXPECT_EQ(has_vertex_at(mesh, 3.0 / 8.0 * (corners[i] + corners[j])), !opposite);
    }
  }
}

// The four vertices sum to zero, so the neighbours of v sum to -v: it goes to
// (1 - 3 * 3/16) - 3/16 = 1/4 of itself, and an edge point to 3/8 - 1/8 of the sum of its ends.
TEST(LoopSubdivision, TetrahedronHasAClosedForm) {
  const HalfedgeMesh mesh = subdivided(tetrahedron());
  ASSERT_EQ(mesh.nVertices(), 10U);
  const std::vector<Vector3D> corners = tetrahedron().positions;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_TRUE(has_vertex_at(mesh, corners[i] / 4.0));
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(has_vertex_at(mesh, (corners[i] + corners[j]) / 4.0));
    }
  }
}

// The second level is the first one of the mesh that the first one gave. Along an axis of the
// octahedron a vertex keeps 4 neighbours at height h, with v at height c: c' = 5/8 c + 3/8 h.
TEST(LoopSubdivision, SecondCallGoesOnFromTheFirst) {
  const HalfedgeMesh mesh = subdivided(octahedron(), 2);
  ASSERT_EQ(mesh.nVertices(), 66U);
  const double c = 5.0 / 8.0 * (5.0 / 8.0) + 3.0 / 8.0 * (3.0 / 8.0);
  for (const Vector3D& corner : octahedron().positions) {
    EXPECT_TRUE(has_vertex_at(mesh, c * corner));
  }
}

TEST(LoopSubdivision, MarksThatAreLeftOverDoNotMatter) {
  HalfedgeMesh mesh = mesh_of(frame());
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    v->isNew = true;
  }
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    e->isNew = true;
  }
  MeshResampler resampler;
  resampler.upsample(mesh);
  EXPECT_EQ(full_wiring(mesh), full_wiring(subdivided(frame())));
}

// In a regular sheet every vertex and every edge is the middle of its neighbours, so nothing
// moves but the four corners, which go to 3/4 themselves + 1/8 of each neighbour.
TEST(LoopSubdivision, RegularSheetMovesItsCornersOnly) {
  const HalfedgeMesh mesh = subdivided(sheet(3, 2));
  ASSERT_EQ(mesh.nVertices(), 7U * 5U);
  for (int j = 0; j <= 4; ++j) {
    for (int i = 0; i <= 6; ++i) {
      const bool corner = (i == 0 || i == 6) && (j == 0 || j == 4);
      const double inward_x = corner ? (i == 0 ? 0.125 : -0.125) : 0.0;
      const double inward_y = corner ? (j == 0 ? 0.125 : -0.125) : 0.0;
      EXPECT_TRUE(has_vertex_at(mesh, Vector3D(0.5 * i + inward_x, 0.5 * j + inward_y, 0)))
          << i << ", " << j;
    }
  }
}

TEST(LoopSubdivision, EdgeInsideBetweenTwoBoundaryVerticesIsAnInnerEdge) {
  Polygons polygons = diamond();
  polygons.positions[0].z = 8.0;
  const HalfedgeMesh mesh = subdivided(polygons);
  const Vector3D expected = 3.0 / 8.0 * (polygons.positions[1] + polygons.positions[2]) +
                            1.0 / 8.0 * (polygons.positions[0] + polygons.positions[3]);
  EXPECT_TRUE(has_vertex_at(mesh, expected));
}

TEST(LoopSubdivision, ComponentsDoNotTouchEachOther) {
  const HalfedgeMesh both = subdivided(together(octahedron(), tetrahedron()));
  for (const Polygons& part : {octahedron(), tetrahedron()}) {
    const HalfedgeMesh alone = subdivided(part);
    for (VertexCIter v = alone.verticesBegin(); v != alone.verticesEnd(); ++v) {
      EXPECT_TRUE(has_vertex_at(both, v->position));
    }
  }
}

TEST(LoopSubdivision, EmptyMeshStaysEmpty) {
  HalfedgeMesh mesh;
  MeshResampler().upsample(mesh);
  EXPECT_EQ(mesh.nVertices(), 0U);
}

}  // namespace
}  // namespace meshedit
