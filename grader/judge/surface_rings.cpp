#include "grader/judge/surface_rings.h"

namespace meshgrade {
namespace {

std::vector<Ref> corners_from(const MeshDump& mesh, Ref first) {
  std::vector<Ref> corners;
  Ref h = first;
  do {
    corners.push_back(mesh.halfedges[h].vertex);
    h = mesh.halfedges[h].next;
  } while (h != first);
  return corners;
}

}  // namespace

SurfaceRings rings_of(const MeshDump& mesh) {
  SurfaceRings rings;
  for (const VertexRecord& v : mesh.vertices)
    rings.positions.push_back(v.position);
  rings.vertices.resize(mesh.vertices.size());
  rings.edges.resize(mesh.edges.size());
  for (const FaceRecord& f : mesh.faces)
    rings.corners.push_back(corners_from(mesh, f.halfedge));
  std::vector<std::vector<Ref>> loops;
  for (const FaceRecord& b : mesh.boundaries)
    loops.push_back(corners_from(mesh, b.halfedge));
  for (Ref e = 0; e < mesh.edges.size(); ++e) {
    SurfaceRings::OfEdge& edge = rings.edges[e];
    const HalfedgeRecord& h = mesh.halfedges[mesh.edges[e].halfedge];
    const HalfedgeRecord& twin = mesh.halfedges[h.twin];
    edge.a = h.vertex;
    edge.b = twin.vertex;
    for (const Ref face : {h.face, twin.face}) {
      if ((face & kBoundaryBit) == 0) {
        edge.faces.push_back(face);
      } else {
        edge.loop = loops[face & ~kBoundaryBit];
      }
    }
  }
  for (const HalfedgeRecord& h : mesh.halfedges) {
    rings.vertices[h.vertex].edges.push_back(h.edge);
    if ((h.face & kBoundaryBit) == 0) rings.vertices[h.vertex].faces.push_back(h.face);
  }
  return rings;
}

}  // namespace meshgrade
