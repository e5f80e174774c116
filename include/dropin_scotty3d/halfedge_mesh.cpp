// What Halfedge_Mesh does by itself. Compiled with each submission; a definition of the same
// function in the student's files wins, so all of these are weak.

#include <array>
#include <sstream>
#include <stdexcept>

#include "detail/mesh_bridge.h"
#include "detail/validator.h"
#include "geometry/halfedge.h"
#include "mesh_access.h"
#include "meshedit/halfedge_mesh.h"

#define SCOTTY3D_OURS [[gnu::weak]]

using meshedit::detail::StepPause;
using meshedit::detail::scotty3d::ElementList;
using meshedit::detail::scotty3d::Link;
using meshedit::detail::scotty3d::LinkState;
using meshedit::detail::scotty3d::MeshAccess;
using meshedit::detail::scotty3d::Reference;

namespace {

constexpr Halfedge_Mesh::Index kErasedBit = 0x80000000U;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
const Vec3 kNoPosition(kNaN, kNaN, kNaN);

/// Twice the area of a face as a vector along its normal, by Newell.
Vec3 area_vector(Halfedge_Mesh::HalfedgeCRef first) {
  Vec3 sum;
  Halfedge_Mesh::HalfedgeCRef h = first;
  const Vec3 origin = first->vertex->position;
  do {
    sum += cross(h->vertex->position - origin, h->next->vertex->position - origin);
    h = h->next;
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
  HalfedgeCRef h = halfedge;
  do {
    if (h->face->boundary) return true;
    h = h->twin->next;
  } while (h != halfedge);
  return false;
}

SCOTTY3D_OURS std::uint32_t Halfedge_Mesh::Vertex::degree() const {
  std::uint32_t n = 0;
  HalfedgeCRef h = halfedge;
  do {
    ++n;
    h = h->twin->next;
  } while (h != halfedge);
  return n;
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Vertex::normal() const {
  Vec3 sum;
  HalfedgeCRef h = halfedge;
  do {
    if (!h->face->boundary) sum += area_vector(h);
    h = h->twin->next;
  } while (h != halfedge);
  return unit_or_zero(sum);
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Vertex::neighborhood_center() const {
  Vec3 sum;
  float n = 0.0f;
  HalfedgeCRef h = halfedge;
  do {
    sum += h->twin->vertex->position;
    n += 1.0f;
    h = h->twin->next;
  } while (h != halfedge);
  return sum / n;
}

SCOTTY3D_OURS float Halfedge_Mesh::Vertex::angle_defect() const {
  float defect = 2.0f * PI_F;
  HalfedgeCRef h = halfedge;
  do {
    HalfedgeCRef after = h->twin->next;
    if (!h->twin->face->boundary) {
      const Vec3 a = unit_or_zero(h->twin->vertex->position - position);
      const Vec3 b = unit_or_zero(after->twin->vertex->position - position);
      defect -= std::acos(std::max(-1.0f, std::min(1.0f, dot(a, b))));
    }
    h = after;
  } while (h != halfedge);
  return defect;
}

SCOTTY3D_OURS float Halfedge_Mesh::Vertex::gaussian_curvature() const {
  float area = 0.0f;
  HalfedgeCRef h = halfedge;
  do {
    if (!h->face->boundary) area += h->face->area() / static_cast<float>(h->face->degree());
    h = h->twin->next;
  } while (h != halfedge);
  return angle_defect() / area;
}

SCOTTY3D_OURS bool Halfedge_Mesh::Edge::on_boundary() const {
  return halfedge->face->boundary || halfedge->twin->face->boundary;
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Edge::center() const {
  return 0.5f * (halfedge->vertex->position + halfedge->twin->vertex->position);
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Edge::normal() const {
  Vec3 sum;
  if (!halfedge->face->boundary) sum += halfedge->face->normal();
  if (!halfedge->twin->face->boundary) sum += halfedge->twin->face->normal();
  return unit_or_zero(sum);
}

SCOTTY3D_OURS float Halfedge_Mesh::Edge::length() const {
  return (halfedge->vertex->position - halfedge->twin->vertex->position).norm();
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Face::center() const {
  Vec3 sum;
  float n = 0.0f;
  HalfedgeCRef h = halfedge;
  do {
    sum += h->vertex->position;
    n += 1.0f;
    h = h->next;
  } while (h != halfedge);
  return sum / n;
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::Face::normal() const {
  return area_vector(halfedge).unit();
}

SCOTTY3D_OURS std::uint32_t Halfedge_Mesh::Face::degree() const {
  std::uint32_t n = 0;
  HalfedgeCRef h = halfedge;
  do {
    ++n;
    h = h->next;
  } while (h != halfedge);
  return n;
}

SCOTTY3D_OURS float Halfedge_Mesh::Face::area() const {
  return 0.5f * area_vector(halfedge).norm();
}

// --- making and erasing ---------------------------------------------------------------------

SCOTTY3D_OURS Halfedge_Mesh::VertexRef Halfedge_Mesh::emplace_vertex() {
  const StepPause pause;
  const VertexRef v = vertices.emplace();
  v->id = next_id_++;
  v->halfedge = halfedges.end();
  return v;
}

SCOTTY3D_OURS Halfedge_Mesh::EdgeRef Halfedge_Mesh::emplace_edge(bool sharp) {
  const StepPause pause;
  const EdgeRef e = edges.emplace();
  e->id = next_id_++;
  e->halfedge = halfedges.end();
  e->sharp = sharp;
  return e;
}

SCOTTY3D_OURS Halfedge_Mesh::FaceRef Halfedge_Mesh::emplace_face(bool boundary) {
  const StepPause pause;
  const FaceRef f = faces.emplace();
  f->id = next_id_++;
  f->halfedge = halfedges.end();
  f->boundary = boundary;
  return f;
}

SCOTTY3D_OURS Halfedge_Mesh::HalfedgeRef Halfedge_Mesh::emplace_halfedge() {
  const StepPause pause;
  const HalfedgeRef h = halfedges.emplace();
  h->id = next_id_++;
  h->set_tnvef(halfedges.end(), halfedges.end(), vertices.end(), edges.end(), faces.end());
  return h;
}

SCOTTY3D_OURS void Halfedge_Mesh::erase_vertex(VertexRef v) {
  if (!vertices.release(v)) return;
  const StepPause pause;
  v->id |= kErasedBit;
  v->halfedge = halfedges.end();
  v->position = kNoPosition;
}

SCOTTY3D_OURS void Halfedge_Mesh::erase_edge(EdgeRef e) {
  if (!edges.release(e)) return;
  const StepPause pause;
  e->id |= kErasedBit;
  e->halfedge = halfedges.end();
}

SCOTTY3D_OURS void Halfedge_Mesh::erase_face(FaceRef f) {
  if (!faces.release(f)) return;
  const StepPause pause;
  f->id |= kErasedBit;
  f->halfedge = halfedges.end();
}

SCOTTY3D_OURS void Halfedge_Mesh::erase_halfedge(HalfedgeRef h) {
  if (!halfedges.release(h)) return;
  const StepPause pause;
  h->id |= kErasedBit;
  h->set_tnvef(halfedges.end(), halfedges.end(), vertices.end(), edges.end(), faces.end());
  h->corner_uv = Vec2(kNaN, kNaN);
  h->corner_normal = kNoPosition;
}

SCOTTY3D_OURS void Halfedge_Mesh::interpolate_data(const std::vector<VertexCRef>& from,
                                                   VertexRef to) {
  std::map<std::uint32_t, float> weights;
  for (const VertexCRef& v : from) {
    for (const Bone_Weight& weight : v->bone_weights)
      weights[weight.bone] += weight.weight / static_cast<float>(from.size());
  }
  to->bone_weights.clear();
  for (const auto& [bone, weight] : weights) {
    Bone_Weight& added = to->bone_weights.emplace_back();
    added.bone = bone;
    added.weight = weight;
  }
}

SCOTTY3D_OURS void Halfedge_Mesh::interpolate_data(const std::vector<HalfedgeCRef>& from,
                                                   HalfedgeRef to) {
  Vec2 uv;
  Vec3 normal;
  for (const HalfedgeCRef& h : from) {
    uv += h->corner_uv;
    normal += h->corner_normal;
  }
  to->corner_uv = uv / static_cast<float>(from.size());
  to->corner_normal = unit_or_zero(normal);
}

// --- whole meshes ---------------------------------------------------------------------------

namespace {

/// Where the elements of a mesh are in its copy.
class Copies {
 public:
  template <class T>
  void copy(const ElementList<T>& from, ElementList<T>& to) {
    copy_of_[from.end().link()] = to.end().link();
    for (Reference<const T> element = from.begin(); element != from.end(); ++element) {
      const Reference<T> made = to.emplace();
      *made = *element;
      copy_of_[element.link()] = made.link();
    }
  }

  /// What led into the mesh leads into its copy; all else, and what is erased, to nothing.
  template <class T>
  void redirect(Reference<T>& reference, ElementList<T>& list) const {
    const auto found = copy_of_.find(reference.link());
    reference = found == copy_of_.end() ? Reference<T>() : list.reference_to(found->second);
  }

 private:
  std::unordered_map<const Link*, Link*> copy_of_;
};

}  // namespace

SCOTTY3D_OURS Halfedge_Mesh::Halfedge_Mesh(const Halfedge_Mesh& mesh)
    : next_id_(mesh.next_id_) {
  const StepPause pause;
  Copies copies;
  copies.copy(mesh.vertices, vertices);
  copies.copy(mesh.edges, edges);
  copies.copy(mesh.faces, faces);
  copies.copy(mesh.halfedges, halfedges);
  for (Vertex& v : vertices)
    copies.redirect(v.halfedge, halfedges);
  for (Edge& e : edges)
    copies.redirect(e.halfedge, halfedges);
  for (Face& f : faces)
    copies.redirect(f.halfedge, halfedges);
  for (Halfedge& h : halfedges) {
    copies.redirect(h.twin, halfedges);
    copies.redirect(h.next, halfedges);
    copies.redirect(h.vertex, vertices);
    copies.redirect(h.edge, edges);
    copies.redirect(h.face, faces);
  }
}

SCOTTY3D_OURS Halfedge_Mesh& Halfedge_Mesh::operator=(const Halfedge_Mesh& mesh) {
  Halfedge_Mesh other(mesh);
  swap(other);
  return *this;
}

SCOTTY3D_OURS void Halfedge_Mesh::swap(Halfedge_Mesh& mesh) noexcept {
  vertices.swap(mesh.vertices);
  edges.swap(mesh.edges);
  faces.swap(mesh.faces);
  halfedges.swap(mesh.halfedges);
  std::swap(next_id_, mesh.next_id_);
}

SCOTTY3D_OURS std::size_t Halfedge_Mesh::n_boundaries() const {
  const StepPause pause;
  return static_cast<std::size_t>(
      std::count_if(faces.begin(), faces.end(), [](const Face& f) { return f.boundary; }));
}

SCOTTY3D_OURS float Halfedge_Mesh::radius() const {
  const StepPause pause;
  float radius = 0.0f;
  for (const Vertex& v : vertices)
    radius = std::max(radius, v.position.norm());
  return radius;
}

SCOTTY3D_OURS Halfedge_Mesh::Index Halfedge_Mesh::id_of(const ElementCRef& element) {
  return std::visit([](const auto& reference) { return reference->id; }, element);
}

namespace {

Vec3 center_of_element(Halfedge_Mesh::VertexCRef v) {
  return v->position;
}
Vec3 center_of_element(Halfedge_Mesh::EdgeCRef e) {
  return e->center();
}
Vec3 center_of_element(Halfedge_Mesh::FaceCRef f) {
  return f->center();
}
Vec3 center_of_element(Halfedge_Mesh::HalfedgeCRef h) {
  return h->edge->center();
}

template <class Ref>
Vec3 normal_of_element(Ref element) {
  return element->normal();
}
Vec3 normal_of_element(Halfedge_Mesh::HalfedgeCRef h) {
  return h->edge->normal();
}

}  // namespace

SCOTTY3D_OURS Vec3 Halfedge_Mesh::center_of(const ElementCRef& element) {
  return std::visit([](const auto& reference) { return center_of_element(reference); },
                    element);
}

SCOTTY3D_OURS Vec3 Halfedge_Mesh::normal_of(const ElementCRef& element) {
  return std::visit([](const auto& reference) { return normal_of_element(reference); },
                    element);
}

namespace {

template <class T>
std::string id_text(const Reference<T>& reference) {
  const Link* link = reference.link();
  if (link == nullptr) return "unset";
  if (link->state == LinkState::kEnd) return "end()";
  return std::to_string(reference->id);
}

}  // namespace

SCOTTY3D_OURS std::string Halfedge_Mesh::describe() const {
  const StepPause pause;
  std::ostringstream out;
  for (VertexCRef v = vertices.begin(); v != vertices.end(); ++v)
    out << "vertex " << v->id << ": halfedge " << id_text(v->halfedge) << ", position "
        << v->position << "\n";
  for (EdgeCRef e = edges.begin(); e != edges.end(); ++e)
    out << "edge " << e->id << ": halfedge " << id_text(e->halfedge)
        << (e->sharp ? ", sharp" : "") << "\n";
  for (FaceCRef f = faces.begin(); f != faces.end(); ++f)
    out << "face " << f->id << ": halfedge " << id_text(f->halfedge)
        << (f->boundary ? ", boundary" : "") << "\n";
  for (HalfedgeCRef h = halfedges.begin(); h != halfedges.end(); ++h)
    out << "halfedge " << h->id << ": twin " << id_text(h->twin) << ", next "
        << id_text(h->next) << ", vertex " << id_text(h->vertex) << ", edge "
        << id_text(h->edge) << ", face " << id_text(h->face) << "\n";
  return out.str();
}

SCOTTY3D_OURS std::optional<std::pair<Halfedge_Mesh::ElementCRef, std::string>>
Halfedge_Mesh::validate() const {
  const StepPause pause;
  return meshedit::detail::scotty3d::Validator<MeshAccess, const Halfedge_Mesh>(*this).find();
}

SCOTTY3D_OURS Halfedge_Mesh Halfedge_Mesh::from_indexed_faces(
    const std::vector<Vec3>& positions, const std::vector<std::vector<Index>>& corners) {
  const StepPause pause;
  std::vector<std::vector<meshedit::Index>> polygons;
  for (const auto& polygon : corners)
    polygons.emplace_back(polygon.begin(), polygon.end());
  std::vector<meshedit::Vector3D> points;
  for (const Vec3& p : positions)
    points.emplace_back(p.x, p.y, p.z);
  meshedit::HalfedgeMesh ours;
  ours.build(polygons, points);
  Halfedge_Mesh mesh;
  const meshedit::detail::scotty3d::MeshBridge<MeshAccess> bridge(ours, mesh);
  return mesh;
}

SCOTTY3D_OURS Halfedge_Mesh Halfedge_Mesh::cube(float radius) {
  std::vector<Vec3> corners;
  for (float z : {-radius, radius}) {
    for (float y : {-radius, radius}) {
      for (float x : {-radius, radius})
        corners.emplace_back(x, y, z);
    }
  }
  return from_indexed_faces(
      corners,
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}
