// What Halfedge_Mesh does by itself. Compiled with each submission; a definition of the same
// function in the student's files wins, so all of these are weak.

#include "dropin_scotty3d/detail/validator.h"
#include "geometry/halfedge.h"
#include "mesh_access.h"

#define SCOTTY3D_OURS [[gnu::weak]]

using meshedit::detail::StepPause;
using meshedit::detail::scotty3d::MeshAccess;

namespace {

/// Twice the area of a face as a vector along its normal, by Newell.
Vec3 area_vector(Halfedge_Mesh::HalfedgeCRef first) {
  Vec3 sum;
  Halfedge_Mesh::HalfedgeCRef h = first;
  const Vec3 origin = first->vertex()->pos;
  do {
    sum += cross(h->vertex()->pos - origin, h->next()->vertex()->pos - origin);
    h = h->next();
  } while (h != first);
  return sum;
}

Vec3 unit_or_zero(const Vec3& v) {
  const float length = v.norm();
  return length > 0.0f ? v / length : Vec3();
}

}  // namespace

// --- elements -------------------------------------------------------------------------------

SCOTTY3D_OURS bool Halfedge_Mesh::Vertex::on_boundary() const {
  HalfedgeCRef h = _halfedge;
  do {
    if (h->is_boundary()) return true;
    h = h->twin()->next();
  } while (h != _halfedge);
  return false;
}

SCOTTY3D_OURS unsigned int Halfedge_Mesh::Vertex::degree() const {
  unsigned int n = 0;
  HalfedgeCRef h = _halfedge;
  do {
    if (!h->is_boundary()) ++n;
    h = h->twin()->next();
  } while (h != _halfedge);
  return n;
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Vertex::normal() const {
  Vec3 sum;
  HalfedgeCRef h = _halfedge;
  do {
    if (!h->is_boundary()) sum += area_vector(h);
    h = h->twin()->next();
  } while (h != _halfedge);
  return unit_or_zero(sum);
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Vertex::neighborhood_center() const {
  Vec3 sum;
  float n = 0.0f;
  HalfedgeCRef h = _halfedge;
  do {
    sum += h->twin()->vertex()->pos;
    n += 1.0f;
    h = h->twin()->next();
  } while (h != _halfedge);
  return sum / n;
}

SCOTTY3D_OURS bool Halfedge_Mesh::Edge::on_boundary() const {
  return _halfedge->is_boundary() || _halfedge->twin()->is_boundary();
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Edge::center() const {
  return 0.5f * (_halfedge->vertex()->pos + _halfedge->twin()->vertex()->pos);
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Edge::normal() const {
  return unit_or_zero(_halfedge->face()->normal() + _halfedge->twin()->face()->normal());
}

SCOTTY3D_OURS float Halfedge_Mesh::Edge::length() const {
  return (_halfedge->vertex()->pos - _halfedge->twin()->vertex()->pos).norm();
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Face::center() const {
  Vec3 sum;
  float n = 0.0f;
  HalfedgeCRef h = _halfedge;
  do {
    sum += h->vertex()->pos;
    n += 1.0f;
    h = h->next();
  } while (h != _halfedge);
  return sum / n;
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Face::normal() const {
  return area_vector(_halfedge).unit();
}

SCOTTY3D_OURS unsigned int Halfedge_Mesh::Face::degree() const {
  unsigned int n = 0;
  HalfedgeCRef h = _halfedge;
  do {
    ++n;
    h = h->next();
  } while (h != _halfedge);
  return n;
}

// --- making and erasing ---------------------------------------------------------------------

namespace {

template <class List>
auto make_element(List& list, unsigned int& next_id) {
  const StepPause pause;
  const auto made = list.emplace();
  made->_id = next_id++;
  return made;
}

/// Looks whether the element is there, so that it is told who erases one that is not.
template <class Reference>
void mark(std::set<Reference>& marked, const Reference& element) {
  (void)*element;
  marked.insert(element);
}

template <class List, class Reference>
void release_marked(List& list, std::set<Reference>& marked) {
  for (const Reference& element : marked)
    list.release(element);
  marked.clear();
}

}  // namespace

SCOTTY3D_OURS Halfedge_Mesh::VertexRef Halfedge_Mesh::new_vertex() {
  return make_element(vertices, next_id);
}

SCOTTY3D_OURS Halfedge_Mesh::EdgeRef Halfedge_Mesh::new_edge() {
  return make_element(edges, next_id);
}

SCOTTY3D_OURS Halfedge_Mesh::FaceRef Halfedge_Mesh::new_face(bool boundary) {
  const StepPause pause;
  const FaceRef f = make_element(faces, next_id);
  f->boundary = boundary;
  return f;
}

SCOTTY3D_OURS Halfedge_Mesh::HalfedgeRef Halfedge_Mesh::new_halfedge() {
  return make_element(halfedges, next_id);
}

SCOTTY3D_OURS void Halfedge_Mesh::erase(VertexRef v) {
  mark(verased, v);
}

SCOTTY3D_OURS void Halfedge_Mesh::erase(EdgeRef e) {
  mark(eerased, e);
}

SCOTTY3D_OURS void Halfedge_Mesh::erase(FaceRef f) {
  mark(ferased, f);
}

SCOTTY3D_OURS void Halfedge_Mesh::erase(HalfedgeRef h) {
  mark(herased, h);
}

SCOTTY3D_OURS void Halfedge_Mesh::do_erase() {
  const StepPause pause;
  release_marked(vertices, verased);
  release_marked(edges, eerased);
  release_marked(faces, ferased);
  release_marked(halfedges, herased);
}

// --- whole meshes ---------------------------------------------------------------------------

SCOTTY3D_OURS Halfedge_Mesh::Size Halfedge_Mesh::n_boundaries() const {
  const StepPause pause;
  return static_cast<Size>(
      std::count_if(faces.begin(), faces.end(), [](const Face& f) { return f.boundary; }));
}

SCOTTY3D_OURS std::optional<std::pair<Halfedge_Mesh::ElementRef, std::string>>
Halfedge_Mesh::validate() {
  const StepPause pause;
  for (VertexRef v = vertices.begin(); v != vertices.end(); ++v) {
    if (!v->pos.valid()) return {{v, "its position is not finite"}};
  }
  auto broken = meshedit::detail::scotty3d::Validator<MeshAccess, Halfedge_Mesh>(*this).find();
  if (!broken) do_erase();
  return broken;
}

SCOTTY3D_OURS unsigned int Halfedge_Mesh::id_of(ElementRef element) {
  return std::visit([](auto reference) { return reference->id(); }, element);
}

namespace {

/// The element whose place and normal those of another one are.
Halfedge_Mesh::EdgeRef shown(Halfedge_Mesh::HalfedgeRef h) {
  return h->edge();
}
Halfedge_Mesh::VertexRef shown(Halfedge_Mesh::VertexRef v) {
  return v;
}
Halfedge_Mesh::EdgeRef shown(Halfedge_Mesh::EdgeRef e) {
  return e;
}
Halfedge_Mesh::FaceRef shown(Halfedge_Mesh::FaceRef f) {
  return f;
}

}  // namespace

SCOTTY3D_OURS Vec3 Halfedge_Mesh::center_of(ElementRef element) {
  return std::visit([](auto reference) { return shown(reference)->center(); }, element);
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::normal_of(ElementRef element) {
  const Vec3 normal =
      std::visit([](auto reference) { return shown(reference)->normal(); }, element);
  return flip_orientation ? -normal : normal;
}
