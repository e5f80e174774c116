#include "detail/mesh_bridge.h"

namespace meshedit {
namespace detail {
namespace scotty3d {
namespace {

/// Elements of a mesh that no case has: where pointers into other meshes lead.
struct StrayElements {
  StrayElements() {
    const StepPause pause;
    vertex = elementAddress(mesh.newVertex());
    edge = elementAddress(mesh.newEdge());
    face = elementAddress(mesh.newFace());
    halfedge = elementAddress(mesh.newHalfedge());
  }

  HalfedgeMesh mesh;
  Vertex* vertex;
  Edge* edge;
  Face* face;
  Halfedge* halfedge;
};

StrayElements& strays() {
  static StrayElements elements;
  return elements;
}

/// A position that floats cannot hold stays what it is until it is changed.
void write_position(const Vec3& from, Vector3D& to) {
  const Vec3 known = to_floats(to);
  const bool is_same = known.x == from.x && known.y == from.y && known.z == from.z;
  if (!is_same) to = Vector3D(from.x, from.y, from.z);
}

}  // namespace

MeshBridge::MeshBridge(HalfedgeMesh& ours, Halfedge_Mesh& theirs)
    : mesh_(ours),
      vertices_(theirs.vertices),
      edges_(theirs.edges),
      faces_(theirs.faces),
      halfedges_(theirs.halfedges) {
  const StepPause pause;
  vertices_.fill(Inspector::vertices(mesh_), [&] { return theirs.emplace_vertex(); });
  faces_.fill(Inspector::faces(mesh_), [&] { return theirs.emplace_face(); });
  faces_.fill(Inspector::boundaries(mesh_), [&] { return theirs.emplace_face(true); });
  edges_.fill(Inspector::edges(mesh_), [&] { return theirs.emplace_edge(); });
  halfedges_.fill(Inspector::halfedges(mesh_), [&] { return theirs.emplace_halfedge(); });
  fill_pointers();
}

void MeshBridge::fill_pointers() {
  const auto halfedge_of = [&](const auto& element) {
    return halfedges_.theirs(Inspector::halfedge(element));
  };
  vertices_.for_each([&](const Vertex& from, Halfedge_Mesh::Vertex& to) {
    to.position = to_floats(from.position);
    to.halfedge = halfedge_of(from);
  });
  edges_.for_each([&](const Edge& from, auto& to) { to.halfedge = halfedge_of(from); });
  faces_.for_each([&](const Face& from, auto& to) { to.halfedge = halfedge_of(from); });
  halfedges_.for_each([&](const Halfedge& from, Halfedge_Mesh::Halfedge& to) {
    to.set_tnvef(halfedges_.theirs(Inspector::twin(from)),
                 halfedges_.theirs(Inspector::next(from)),
                 vertices_.theirs(Inspector::vertex(from)),
                 edges_.theirs(Inspector::edge(from)), faces_.theirs(Inspector::face(from)));
  });
}

void MeshBridge::write_back() {
  const StepPause pause;
  settle_vertices();
  settle_edges();
  settle_faces();
  settle_halfedges();
  write_pointers();
}

void MeshBridge::settle_vertices() {
  const auto remove = [&](Vertex* v) { mesh_.deleteVertex(Inspector::handle(v)); };
  vertices_.settle(
      [](Vertex* v, const Halfedge_Mesh::Vertex& from) {
        write_position(from.position, v->position);
        return v;
      },
      remove,
      [&](const Halfedge_Mesh::Vertex& from, bool is_live) {
        Vertex* v = elementAddress(mesh_.newVertex());
        v->position = Vector3D(from.position.x, from.position.y, from.position.z);
        if (!is_live) remove(v);
        return v;
      });
}

void MeshBridge::settle_edges() {
  const auto remove = [&](Edge* e) { mesh_.deleteEdge(Inspector::handle(e)); };
  edges_.settle([](Edge* e, const Halfedge_Mesh::Edge& /*from*/) { return e; }, remove,
                [&](const Halfedge_Mesh::Edge& /*from*/, bool is_live) {
                  Edge* e = elementAddress(mesh_.newEdge());
                  if (!is_live) remove(e);
                  return e;
                });
}

/// Ours are in two lists: a face that has become a boundary, or the other way, is another one.
void MeshBridge::settle_faces() {
  const auto remove = [&](Face* f) {
    f->isBoundary() ? mesh_.deleteBoundary(Inspector::handle(f))
                    : mesh_.deleteFace(Inspector::handle(f));
  };
  const auto make = [&](bool boundary) {
    return elementAddress(boundary ? mesh_.newBoundary() : mesh_.newFace());
  };
  faces_.settle(
      [&](Face* f, const Halfedge_Mesh::Face& from) {
        if (f->isBoundary() == from.boundary) return f;
        remove(f);
        return make(from.boundary);
      },
      remove,
      [&](const Halfedge_Mesh::Face& from, bool is_live) {
        Face* f = make(from.boundary);
        if (!is_live) remove(f);
        return f;
      });
}

void MeshBridge::settle_halfedges() {
  const auto remove = [&](Halfedge* h) { mesh_.deleteHalfedge(Inspector::handle(h)); };
  halfedges_.settle([](Halfedge* h, const Halfedge_Mesh::Halfedge& /*from*/) { return h; },
                    remove,
                    [&](const Halfedge_Mesh::Halfedge& /*from*/, bool is_live) {
                      Halfedge* h = elementAddress(mesh_.newHalfedge());
                      if (!is_live) remove(h);
                      return h;
                    });
}

void MeshBridge::write_pointers() {
  vertices_.for_each(
      [&](Vertex& to, const auto& from) { to.halfedge() = ours(from.halfedge); });
  edges_.for_each([&](Edge& to, const auto& from) { to.halfedge() = ours(from.halfedge); });
  faces_.for_each([&](Face& to, const auto& from) { to.halfedge() = ours(from.halfedge); });
  halfedges_.for_each([&](Halfedge& to, const Halfedge_Mesh::Halfedge& from) {
    to.twin() = ours(from.twin);
    to.next() = ours(from.next);
    to.vertex() = ours(from.vertex);
    to.edge() = ours(from.edge);
    to.face() = ours(from.face);
  });
}

VertexIter MeshBridge::ours(const Reference<const Halfedge_Mesh::Vertex>& v) const {
  return vertices_.ours(v, strays().vertex);
}
EdgeIter MeshBridge::ours(const Reference<const Halfedge_Mesh::Edge>& e) const {
  return edges_.ours(e, strays().edge);
}
FaceIter MeshBridge::ours(const Reference<const Halfedge_Mesh::Face>& f) const {
  return faces_.ours(f, strays().face);
}
HalfedgeIter MeshBridge::ours(const Reference<const Halfedge_Mesh::Halfedge>& h) const {
  return halfedges_.ours(h, strays().halfedge);
}

}  // namespace scotty3d
}  // namespace detail
}  // namespace meshedit
