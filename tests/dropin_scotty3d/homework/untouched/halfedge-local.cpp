
#include "halfedge.h"

#include <unordered_map>
#include <unordered_set>
#include <functional>
#include <iostream>

// add_face: from corners
Halfedge_Mesh::FaceRef Halfedge_Mesh::add_face(std::vector<VertexRef> const &face_vertices, bool boundary) {
	assert(face_vertices.size() >= 3);
	FaceRef face = emplace_face(boundary);
	return face;
}

Halfedge_Mesh::VertexRef Halfedge_Mesh::bisect_edge(EdgeRef e) {
	VertexRef vm = emplace_vertex();
	vm->position = e->center();
	return vm;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::split_edge(EdgeRef e) {
	// A2L2: to be written

	(void)e; //no warning
    return std::nullopt;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::inset_vertex(FaceRef f) {
	(void)f;
    return std::nullopt;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::bevel_vertex(VertexRef v) {
	(void)v;
    return std::nullopt;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::bevel_edge(EdgeRef e) {
	(void)e;
    return std::nullopt;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::extrude_face(FaceRef f) {
	(void)f;
    return std::nullopt;
}

std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(EdgeRef e) {
    return std::nullopt;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::make_boundary(FaceRef face) {
	return std::nullopt; //TODO: actually write this code!
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::dissolve_vertex(VertexRef v) {
    return std::nullopt;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::dissolve_edge(EdgeRef e) {
	// (nothing yet)
    return std::nullopt;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::collapse_edge(EdgeRef e) {
    return std::nullopt;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::collapse_face(FaceRef f) {
    return std::nullopt;
}

std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::weld_edges(EdgeRef e, EdgeRef e2) {
    return std::nullopt;
}

void Halfedge_Mesh::bevel_positions(FaceRef face, std::vector<Vec3> const &start_positions, Vec3 direction, float distance) {
	// nothing
}

void Halfedge_Mesh::extrude_positions(FaceRef face, Vec3 move, float shrink) {
}
