#include "mesh_invariants.h"

#include <iterator>
#include <stdexcept>

#include "meshedit/detail/inspector.h"

namespace meshedit {

namespace {

using detail::Inspector;
using Row = std::vector<std::ptrdiff_t>;

class RuleCheck {
 public:
  RuleCheck(const HalfedgeMesh& mesh, bool triangles_only)
      : mesh_(mesh), triangles_only_(triangles_only) {}

  std::string first_broken() {
    check_pointers();
    if (broken_.empty()) check_halfedges();
    if (broken_.empty()) check_anchors();
    if (broken_.empty()) check_faces();
    if (broken_.empty()) check_vertex_fans();
    return broken_;
  }

 private:
  void ask(bool holds, const char* rule, const char* kind, std::size_t i) {
    if (!holds && broken_.empty())
      broken_ = std::string(rule) + " at " + kind + std::to_string(i);
  }

  template <class T, class Visit>
  static void for_live(const detail::Pool<T>& pool, Visit visit) {
    for (std::size_t i = 0; i < pool.slots(); ++i) {
      if (Inspector::is_live(*pool.at(i))) visit(*pool.at(i), i);
    }
  }

  template <class T>
  static bool is_in(const detail::Pool<T>& pool, const T* element) {
    const std::ptrdiff_t i = pool.find(element);
    return i >= 0 && Inspector::is_live(*element);
  }

  void check_pointers() {
    const auto& halfedges = Inspector::halfedges(mesh_);
    for_live(halfedges, [&](const Halfedge& h, std::size_t i) {
      ask(is_in(halfedges, Inspector::twin(h)), "live twin", "h", i);
      ask(is_in(halfedges, Inspector::next(h)), "live next", "h", i);
      ask(is_in(Inspector::vertices(mesh_), Inspector::vertex(h)), "live vertex", "h", i);
      ask(is_in(Inspector::edges(mesh_), Inspector::edge(h)), "live edge", "h", i);
      ask(is_in(Inspector::faces(mesh_), Inspector::face(h)) ||
              is_in(Inspector::boundaries(mesh_), Inspector::face(h)),
          "live face", "h", i);
    });
    const auto check_anchor = [&](const auto& element, std::size_t i) {
      ask(is_in(halfedges, Inspector::halfedge(element)), "live halfedge", "anchor ", i);
    };
    for_live(Inspector::vertices(mesh_), check_anchor);
    for_live(Inspector::edges(mesh_), check_anchor);
    for_live(Inspector::faces(mesh_), check_anchor);
    for_live(Inspector::boundaries(mesh_), check_anchor);
  }

  void check_halfedges() {
    std::vector<int> times_next(Inspector::halfedges(mesh_).slots(), 0);
    for_live(Inspector::halfedges(mesh_), [&](const Halfedge& h, std::size_t i) {
      const Halfedge& twin = *Inspector::twin(h);
      const Halfedge& next = *Inspector::next(h);
      ask(&twin != &h && Inspector::twin(twin) == &h, "twin-involution", "h", i);
      ask(Inspector::edge(twin) == Inspector::edge(h), "twin-edge", "h", i);
      ask(Inspector::vertex(twin) == Inspector::vertex(next), "twin-opposite", "h", i);
      ask(Inspector::face(next) == Inspector::face(h), "next-face", "h", i);
      ask(Inspector::vertex(twin) != Inspector::vertex(h), "simple", "h", i);
      ++times_next[static_cast<std::size_t>(Inspector::halfedges(mesh_).find(&next))];
    });
    for_live(Inspector::halfedges(mesh_), [&](const Halfedge& /*h*/, std::size_t i) {
      ask(times_next[i] == 1, "next-permutation", "h", i);
    });
    ask(mesh_.nHalfedges() == 2 * mesh_.nEdges(), "two half-edges per edge", "", 0);
  }

  void check_anchors() {
    for_live(Inspector::vertices(mesh_), [&](const Vertex& v, std::size_t i) {
      ask(Inspector::vertex(*Inspector::halfedge(v)) == &v, "anchor", "v", i);
    });
    for_live(Inspector::edges(mesh_), [&](const Edge& e, std::size_t i) {
      ask(Inspector::edge(*Inspector::halfedge(e)) == &e, "anchor", "e", i);
    });
    for_live(Inspector::faces(mesh_), [&](const Face& f, std::size_t i) {
      ask(Inspector::face(*Inspector::halfedge(f)) == &f, "anchor", "f", i);
      ask(!f.isBoundary(), "boundary", "f", i);
    });
    for_live(Inspector::boundaries(mesh_), [&](const Face& f, std::size_t i) {
      ask(Inspector::face(*Inspector::halfedge(f)) == &f, "anchor", "b", i);
      ask(f.isBoundary(), "boundary", "b", i);
    });
  }

  // Every half-edge lies in one loop, as next() is a permutation. So the loops of all faces
  // must have as many half-edges as there are.
  void check_faces() {
    std::size_t in_loops = 0;
    for_live(Inspector::faces(mesh_), [&](const Face& f, std::size_t i) {
      in_loops += f.degree();
      ask(f.degree() == 3 || (!triangles_only_ && f.degree() > 3), "face-loop", "f", i);
    });
    for_live(Inspector::boundaries(mesh_),
             [&](const Face& b, std::size_t /*i*/) { in_loops += b.degree(); });
    ask(in_loops == mesh_.nHalfedges(), "face-loop", "", in_loops);
  }

  void check_vertex_fans() {
    std::size_t in_fans = 0;
    for_live(Inspector::vertices(mesh_), [&](const Vertex& v, std::size_t /*i*/) {
      const Halfedge* h = Inspector::halfedge(v);
      do {
        ++in_fans;
        h = Inspector::next(*Inspector::twin(*h));
      } while (h != Inspector::halfedge(v));
    });
    ask(in_fans == mesh_.nHalfedges(), "vertex-fan", "", in_fans);
  }

  const HalfedgeMesh& mesh_;
  bool triangles_only_;
  std::string broken_;
};

/// Faces count from 0, boundary loops from -2 down; -1 is a pointer to no element.
std::ptrdiff_t face_number(const HalfedgeMesh& mesh, const Face* face) {
  const std::ptrdiff_t outside = Inspector::boundaries(mesh).find(face);
  return outside >= 0 ? -2 - outside : Inspector::faces(mesh).find(face);
}

template <class T>
Row anchors_of(const HalfedgeMesh& mesh, const detail::Pool<T>& pool) {
  Row row;
  for (std::size_t i = 0; i < pool.slots(); ++i) {
    row.push_back(Inspector::halfedges(mesh).find(Inspector::halfedge(*pool.at(i))));
  }
  return row;
}

}  // namespace

std::string broken_rule(const HalfedgeMesh& mesh, bool triangles_only) {
  return RuleCheck(mesh, triangles_only).first_broken();
}

std::vector<Row> wiring(const HalfedgeMesh& mesh) {
  std::vector<Row> rows;
  const auto& halfedges = Inspector::halfedges(mesh);
  for (std::size_t i = 0; i < halfedges.slots(); ++i) {
    const Halfedge& h = *halfedges.at(i);
    rows.push_back({halfedges.find(Inspector::twin(h)), halfedges.find(Inspector::next(h)),
                    Inspector::vertices(mesh).find(Inspector::vertex(h)),
                    Inspector::edges(mesh).find(Inspector::edge(h)),
                    face_number(mesh, Inspector::face(h))});
  }
  return rows;
}

std::vector<Row> full_wiring(const HalfedgeMesh& mesh) {
  std::vector<Row> rows = wiring(mesh);
  rows.push_back(anchors_of(mesh, Inspector::vertices(mesh)));
  rows.push_back(anchors_of(mesh, Inspector::edges(mesh)));
  rows.push_back(anchors_of(mesh, Inspector::faces(mesh)));
  rows.push_back(anchors_of(mesh, Inspector::boundaries(mesh)));
  return rows;
}

Index number_of(const HalfedgeMesh& mesh, VertexCIter v) {
  return static_cast<Index>(std::distance(mesh.verticesBegin(), v));
}

VertexIter vertex_at(HalfedgeMesh& mesh, Index i) {
  return std::next(mesh.verticesBegin(), static_cast<std::ptrdiff_t>(i));
}

EdgeIter edge_between(HalfedgeMesh& mesh, Index a, Index b) {
  const VertexIter to = vertex_at(mesh, b);
  const HalfedgeIter first = vertex_at(mesh, a)->halfedge();
  HalfedgeIter h = first;
  do {
    if (h->twin()->vertex() == to) return h->edge();
    h = h->twin()->next();
  } while (h != first);
  throw std::invalid_argument("no edge joins these vertices");
}

}  // namespace meshedit
