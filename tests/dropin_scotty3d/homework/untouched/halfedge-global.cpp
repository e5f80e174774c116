#include "halfedge.h"

#include <queue>
#include <sstream>
#include <set>

void Halfedge_Mesh::triangulate() {
}

void Halfedge_Mesh::linear_subdivide() {
	std::unordered_map< VertexCRef, Vec3 > vertex_positions;
	std::unordered_map< EdgeCRef, Vec3 > edge_vertex_positions;
	std::unordered_map< FaceCRef, Vec3 > face_vertex_positions;
	catmark_subdivide_helper(vertex_positions, edge_vertex_positions, face_vertex_positions);
}

bool Halfedge_Mesh::loop_subdivide() {
	std::vector< EdgeRef > new_edges;
	[[maybe_unused]] auto is_new = [&](EdgeRef e) { return !new_edges.empty() && e == new_edges[0]; };
	return true;
}

void Halfedge_Mesh::isotropic_remesh(Isotropic_Remesh_Parameters const &params) {
	//Compute the mean length, then repeat the steps.
}

struct Edge_Record {
	Edge_Record(std::unordered_map<Halfedge_Mesh::VertexCRef, Mat4>& vertex_quadrics, Halfedge_Mesh::EdgeRef e) : edge(e) {
		(void)vertex_quadrics;
	}
	Halfedge_Mesh::EdgeRef edge;
	Vec3 optimal;
	float cost = 0.0f;
};

bool operator<(const Edge_Record& r1, const Edge_Record& r2) {
	if (r1.cost != r2.cost) return r1.cost < r2.cost;
	return &*r1.edge < &*r2.edge;
}

template<class T> struct MutablePriorityQueue {
	void insert(const T& item) { queue.insert(item); }
	size_t size() const { return queue.size(); }
	std::set<T> queue;
};

bool Halfedge_Mesh::simplify(float ratio) {
	std::unordered_map< VertexCRef, Mat4 > vertex_quadrics;
	MutablePriorityQueue< Edge_Record > queue;
	for (EdgeRef e = edges.begin(); e != edges.end(); ++e) queue.insert(Edge_Record(vertex_quadrics, e));
	(void)ratio;
	return false;
}

void Halfedge_Mesh::catmark_subdivide_helper(
	std::unordered_map< VertexCRef, Vec3 > const &vertex_positions,
	std::unordered_map< EdgeCRef, Vec3 > const &edge_vertex_positions,
	std::unordered_map< FaceCRef, Vec3 > const &face_vertex_positions) {
	for (auto const& [v, p] : vertex_positions) {
		(void)v; (void)p;
	}
}

void Halfedge_Mesh::flip_orientation() {
	for (HalfedgeRef h = halfedges.begin(); h != halfedges.end(); ++h) {
		h->corner_normal = -h->corner_normal;
	}
}

void Halfedge_Mesh::set_corner_normals(float threshold) {
	float min_cos = std::cos(Radians(std::clamp(threshold, 0.0f, 180.0f)));
	for (auto& h : halfedges) h.corner_normal = min_cos * Vec3{1.0f, 0.0f, 0.0f};
}

void Halfedge_Mesh::set_corner_uvs_per_face() {
	for (auto& h : halfedges) h.corner_uv = Vec2{0.0f, 1.0f};
}

void Halfedge_Mesh::set_corner_uvs_project(Vec3 origin, Vec3 u_axis, Vec3 v_axis) {
	for (auto& h : halfedges) h.corner_uv = Vec2{dot(h.vertex->position - origin, u_axis), dot(h.vertex->position - origin, v_axis)};
}
