#pragma once

// The plain way to write the teaching mesh: four std::lists, their iterators as handles, and
// twins found through a std::map. It takes the place of the shared headers when the reference
// is compiled for comparison. Closed meshes only.

#include <cstddef>
#include <list>
#include <map>
#include <utility>
#include <vector>

#include "../../../../include/meshedit/vector3d.h"

namespace meshedit {

class Halfedge;
class Vertex;
class Edge;
class Face;

using HalfedgeIter = std::list<Halfedge>::iterator;
using HalfedgeCIter = std::list<Halfedge>::const_iterator;
using VertexIter = std::list<Vertex>::iterator;
using VertexCIter = std::list<Vertex>::const_iterator;
using EdgeIter = std::list<Edge>::iterator;
using EdgeCIter = std::list<Edge>::const_iterator;
using FaceIter = std::list<Face>::iterator;
using FaceCIter = std::list<Face>::const_iterator;

using Index = std::size_t;
using Size = std::size_t;

class Halfedge {
 public:
  HalfedgeIter& twin() { return _twin; }
  HalfedgeIter& next() { return _next; }
  VertexIter& vertex() { return _vertex; }
  EdgeIter& edge() { return _edge; }
  FaceIter& face() { return _face; }

  HalfedgeCIter twin() const { return _twin; }
  HalfedgeCIter next() const { return _next; }
  VertexCIter vertex() const { return _vertex; }
  EdgeCIter edge() const { return _edge; }
  FaceCIter face() const { return _face; }

  bool isBoundary() const;
  void setNeighbors(HalfedgeIter next, HalfedgeIter twin, VertexIter vertex, EdgeIter edge,
                    FaceIter face) {
    _next = next;
    _twin = twin;
    _vertex = vertex;
    _edge = edge;
    _face = face;
  }

 private:
  HalfedgeIter _twin;
  HalfedgeIter _next;
  VertexIter _vertex;
  EdgeIter _edge;
  FaceIter _face;
};

class Vertex {
 public:
  HalfedgeIter& halfedge() { return _halfedge; }
  HalfedgeCIter halfedge() const { return _halfedge; }
  bool isBoundary() const;
  Size degree() const;
  Vector3D normal() const;

  Vector3D position;
  Vector3D newPosition;
  Vector3D centroid;
  bool isNew = false;

 private:
  HalfedgeIter _halfedge;
};

class EdgeRecord {
 public:
  EdgeIter edge;
  Vector3D optimalPoint;
  double score = 0.0;
};

class Edge {
 public:
  HalfedgeIter& halfedge() { return _halfedge; }
  HalfedgeCIter halfedge() const { return _halfedge; }
  bool isBoundary() const;

  bool isNew = false;
  Vector3D newPosition;
  EdgeRecord record;

 private:
  HalfedgeIter _halfedge;
};

class Face {
 public:
  HalfedgeIter& halfedge() { return _halfedge; }
  HalfedgeCIter halfedge() const { return _halfedge; }
  bool isBoundary() const { return _isBoundary; }

 private:
  HalfedgeIter _halfedge;
  bool _isBoundary = false;
};

inline bool Halfedge::isBoundary() const {
  return _face->isBoundary();
}

inline bool Edge::isBoundary() const {
  return _halfedge->isBoundary() || _halfedge->twin()->isBoundary();
}

inline bool Vertex::isBoundary() const {
  HalfedgeCIter h = _halfedge;
  do {
    if (h->isBoundary()) return true;
    h = h->twin()->next();
  } while (h != _halfedge);
  return false;
}

inline Size Vertex::degree() const {
  Size faces_around = 0;
  HalfedgeCIter h = _halfedge;
  do {
    if (!h->isBoundary()) ++faces_around;
    h = h->twin()->next();
  } while (h != _halfedge);
  return faces_around;
}

class HalfedgeMesh {
 public:
  void build(const std::vector<std::vector<Index>>& polygons,
             const std::vector<Vector3D>& positions) {
    std::vector<VertexIter> vertex_of;
    for (const Vector3D& position : positions) {
      vertex_of.push_back(newVertex());
      vertex_of.back()->position = position;
    }
    std::map<std::pair<Index, Index>, HalfedgeIter> halfedge_of;
    for (const std::vector<Index>& corners : polygons)
      add_face(corners, vertex_of, halfedge_of);
    for (auto& [ends, h] : halfedge_of) {
      h->twin() = halfedge_of.at({ends.second, ends.first});
      if (ends.second < ends.first) continue;
      const EdgeIter edge = newEdge();
      edge->halfedge() = h;
      h->edge() = h->twin()->edge() = edge;
    }
  }

  Size nEdges() const { return edges.size(); }
  Size nFaces() const { return faces.size(); }
  Size nVertices() const { return vertices.size(); }
  VertexIter verticesBegin() { return vertices.begin(); }
  VertexIter verticesEnd() { return vertices.end(); }
  EdgeIter edgesBegin() { return edges.begin(); }
  EdgeIter edgesEnd() { return edges.end(); }
  FaceIter facesBegin() { return faces.begin(); }
  FaceIter facesEnd() { return faces.end(); }

  HalfedgeIter newHalfedge() { return halfedges.emplace(halfedges.end()); }
  VertexIter newVertex() { return vertices.emplace(vertices.end()); }
  EdgeIter newEdge() { return edges.emplace(edges.end()); }
  FaceIter newFace() { return faces.emplace(faces.end()); }

  EdgeIter flipEdge(EdgeIter e0);
  VertexIter splitEdge(EdgeIter e0);

 private:
  void add_face(const std::vector<Index>& corners, const std::vector<VertexIter>& vertex_of,
                std::map<std::pair<Index, Index>, HalfedgeIter>& halfedge_of) {
    const FaceIter face = newFace();
    std::vector<HalfedgeIter> around;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const HalfedgeIter h = newHalfedge();
      h->vertex() = vertex_of[corners[i]];
      h->vertex()->halfedge() = h;
      h->face() = face;
      halfedge_of[{corners[i], corners[(i + 1) % corners.size()]}] = h;
      around.push_back(h);
    }
    for (std::size_t i = 0; i < around.size(); ++i)
      around[i]->next() = around[(i + 1) % around.size()];
    face->halfedge() = around.front();
  }

  std::list<Halfedge> halfedges;
  std::list<Vertex> vertices;
  std::list<Edge> edges;
  std::list<Face> faces;
};

class MeshResampler {
 public:
  void upsample(HalfedgeMesh& mesh);
};

}  // namespace meshedit
