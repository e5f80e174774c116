#pragma once

// Included behind the class Halfedge_Mesh of each year: in the course its references are the
// iterators of a list, so that some write `std::list<Halfedge_Mesh::Vertex>::iterator`.

namespace std {  // NOLINT(cert-dcl58-cpp): for types of our own
template <>
class list<Halfedge_Mesh::Halfedge>
    : public meshedit::detail::scotty3d::ElementList<Halfedge_Mesh::Halfedge> {};
template <>
class list<Halfedge_Mesh::Vertex>
    : public meshedit::detail::scotty3d::ElementList<Halfedge_Mesh::Vertex> {};
template <>
class list<Halfedge_Mesh::Edge>
    : public meshedit::detail::scotty3d::ElementList<Halfedge_Mesh::Edge> {};
template <>
class list<Halfedge_Mesh::Face>
    : public meshedit::detail::scotty3d::ElementList<Halfedge_Mesh::Face> {};
}  // namespace std
