#include "grader/judge/operation_model.h"

#include <set>

#include "grader/mesh/build_mesh.h"
namespace meshgrade {
namespace {

bool is_outside(const MeshDump& mesh, Ref h) {
  return (mesh.halfedges[h].face & kBoundaryBit) != 0;
}

/// The half-edge of an edge that lies inside, the edge's own one if both do.
Ref inner_halfedge(const MeshDump& mesh, Ref edge) {
  const Ref h = mesh.edges[edge].halfedge;
  return is_outside(mesh, h) ? mesh.halfedges[h].twin : h;
}

Ref next_of(const MeshDump& mesh, Ref h) {
  return mesh.halfedges[h].next;
}

void make_triangle(MeshDump& mesh, Ref face, Ref x, Ref y, Ref z) {
  mesh.halfedges[y].next = z;
  mesh.halfedges[z].next = x;
  mesh.halfedges[x].next = y;
  for (Ref h : {x, y, z})
    mesh.halfedges[h].face = face;
  mesh.faces[face].halfedge = x;
}

/// A new edge with two half-edges, the first from `from`, the second from `to`.
Ref add_edge(MeshDump& mesh, Ref from, Ref to) {
  const Ref h = static_cast<Ref>(mesh.halfedges.size());
  const Ref e = static_cast<Ref>(mesh.edges.size());
  mesh.halfedges.push_back({kUnsetRef, h + 1, from, e, kUnsetRef, 1});
  mesh.halfedges.push_back({kUnsetRef, h, to, e, kUnsetRef, 1});
  mesh.edges.push_back({h, 1});
  return h;
}

Ref add_face(MeshDump& mesh) {
  mesh.faces.push_back({kUnsetRef, 1, 0});
  return static_cast<Ref>(mesh.faces.size() - 1);
}

Ref add_midpoint(MeshDump& mesh, Ref b, Ref c) {
  VertexRecord m{kUnsetRef, 1, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    m.position[i] = 0.5 * (mesh.vertices[b].position[i] + mesh.vertices[c].position[i]);
  }
  mesh.vertices.push_back(m);
  return static_cast<Ref>(mesh.vertices.size() - 1);
}

}  // namespace

Ref find_edge(const MeshDump& mesh, Ref a, Ref b) {
  for (Ref e = 0; e < mesh.edges.size(); ++e) {
    if (mesh.edges[e].live == 0) continue;
    const HalfedgeRecord& h = mesh.halfedges[mesh.edges[e].halfedge];
    const Ref end = mesh.halfedges[h.twin].vertex;
    if ((h.vertex == a && end == b) || (h.vertex == b && end == a)) return e;
  }
  return kUnsetRef;
}

bool is_boundary_edge(const MeshDump& mesh, Ref edge) {
  const Ref h = mesh.edges[edge].halfedge;
  return is_outside(mesh, h) || is_outside(mesh, mesh.halfedges[h].twin);
}

Diamond diamond_of(const MeshDump& mesh, Ref edge) {
  const Ref h = inner_halfedge(mesh, edge);
  const Ref t = mesh.halfedges[h].twin;
  const auto third = [&](Ref g) {
    return mesh.halfedges[next_of(mesh, next_of(mesh, g))].vertex;
  };
  Diamond diamond;
  diamond.a = third(h);
  diamond.b = mesh.halfedges[h].vertex;
  diamond.c = mesh.halfedges[t].vertex;
  if (!is_outside(mesh, t)) diamond.d = third(t);
  return diamond;
}

void model_anchor_on(MeshDump& mesh, Ref edge, std::uint32_t way) {
  Ref& anchor = mesh.edges[edge].halfedge;
  if (way < kAnchorWays / 2) anchor = mesh.halfedges[anchor].twin;
  const Ref h = anchor;
  std::set<Ref> on_boundary;
  for (const HalfedgeRecord& other : mesh.halfedges) {
    if (other.live != 0 && (other.face & kBoundaryBit) != 0) on_boundary.insert(other.vertex);
  }
  for (Ref side : {h, mesh.halfedges[h].twin}) {
    for (std::uint32_t i = 0; i < way % 3; ++i)
      side = next_of(mesh, side);
    const HalfedgeRecord& record = mesh.halfedges[side];
    if ((record.face & kBoundaryBit) != 0) {
      mesh.boundaries[record.face & ~kBoundaryBit].halfedge = side;
    } else {
      mesh.faces[record.face].halfedge = side;
    }
    if (on_boundary.count(record.vertex) == 0) mesh.vertices[record.vertex].halfedge = side;
  }
}

void model_flip(MeshDump& mesh, Ref edge) {
  const Ref bc = mesh.edges[edge].halfedge;
  const Ref cb = mesh.halfedges[bc].twin;
  const Ref ca = next_of(mesh, bc);
  const Ref ab = next_of(mesh, ca);
  const Ref bd = next_of(mesh, cb);
  const Ref dc = next_of(mesh, bd);
  const Ref b = mesh.halfedges[bc].vertex;
  const Ref c = mesh.halfedges[cb].vertex;
  const Ref left = mesh.halfedges[bc].face;
  const Ref right = mesh.halfedges[cb].face;
  const Ref a = mesh.halfedges[ab].vertex;
  const Ref d = mesh.halfedges[dc].vertex;
  make_triangle(mesh, left, bc, ab, bd);
  make_triangle(mesh, right, cb, dc, ca);
  mesh.halfedges[bc].vertex = d;  // bc becomes d -> a
  mesh.halfedges[cb].vertex = a;  // cb becomes a -> d
  mesh.vertices[b].halfedge = bd;
  mesh.vertices[c].halfedge = ca;
}

Ref model_split(MeshDump& mesh, Ref edge) {
  const Ref bm = inner_halfedge(mesh, edge);
  const Ref mb = mesh.halfedges[bm].twin;
  const Ref ca = next_of(mesh, bm);
  const Ref ab = next_of(mesh, ca);
  const Ref b = mesh.halfedges[bm].vertex;
  const Ref c = mesh.halfedges[mb].vertex;
  const Ref a = mesh.halfedges[ab].vertex;
  const Ref left = mesh.halfedges[bm].face;
  const Ref right = mesh.halfedges[mb].face;
  const bool outside = is_outside(mesh, mb);

  const Ref m = add_midpoint(mesh, b, c);
  const Ref mc = add_edge(mesh, m, c);
  const Ref cm = mc + 1;
  const Ref ma = add_edge(mesh, m, a);
  const Ref am = ma + 1;
  mesh.halfedges[mb].vertex = m;
  mesh.vertices[m].halfedge = mc;
  mesh.vertices[c].halfedge = cm;
  make_triangle(mesh, left, bm, ma, ab);
  make_triangle(mesh, add_face(mesh), mc, ca, am);
  if (outside) {
    // The loop outside runs c -> m -> b; cm goes in where mb was.
    for (HalfedgeRecord& h : mesh.halfedges) {
      if (h.next == mb) h.next = cm;
    }
    mesh.halfedges[cm].next = mb;
    mesh.halfedges[cm].face = right;
    return m;
  }
  const Ref bd = next_of(mesh, mb);
  const Ref dc = next_of(mesh, bd);
  const Ref d = mesh.halfedges[dc].vertex;
  const Ref md = add_edge(mesh, m, d);
  const Ref dm = md + 1;
  make_triangle(mesh, right, mb, bd, dm);
  make_triangle(mesh, add_face(mesh), cm, md, dc);
  return m;
}

}  // namespace meshgrade
