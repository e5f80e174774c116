#include "halfedge.h"
#include <set>
#include <queue>

// fans from the first corner
void Halfedge_Mesh::triangulate() {
	for (FaceRef f = faces.begin(); f != faces.end(); f++) {
		if (f->boundary) continue;
		auto sides = f->sides();
		HalfedgeRef top = sides[0];
		for (size_t i = 2; i + 1 < sides.size(); i++) {
			// cut off the triangle of top, sides[i - 1] and the new edge
			EdgeRef e = emplace_edge();
			HalfedgeRef in = emplace_halfedge(), out = emplace_halfedge();
			FaceRef t = emplace_face();
			in->vertex = sides[i]->vertex;
			out->vertex = sides[0]->vertex;
			pair_up(in, out, e);
			HalfedgeRef a = top, b = sides[i - 1];
			a->next = b; b->next = in; in->next = a;
			for (auto k : {a, b, in}) k->face = t;
			t->halfedge = a;
			out->face = f;
			out->next = sides[i];
			sides.back()->next = out;
			f->halfedge = out;
			top = out;
		}
	}
}

void Halfedge_Mesh::linear_subdivide() {
	std::unordered_map< VertexCRef, Vec3 > vertex_positions;
	std::unordered_map< EdgeCRef, Vec3 > edge_vertex_positions;
	std::unordered_map< FaceCRef, Vec3 > face_vertex_positions;
	for (VertexCRef v = vertices.begin(); v != vertices.end(); v++) vertex_positions[v] = v->position;
	for (EdgeCRef e = edges.begin(); e != edges.end(); e++) edge_vertex_positions[e] = e->center();
	for (FaceCRef f = faces.begin(); f != faces.end(); f++) {
		if (f->boundary) continue;
		face_vertex_positions[f] = f->center();
	}
	catmark_subdivide_helper(vertex_positions, edge_vertex_positions, face_vertex_positions);
}

void Halfedge_Mesh::catmark_subdivide() {
	std::unordered_map< VertexCRef, Vec3 > vp;
	std::unordered_map< EdgeCRef, Vec3 > ep;
	std::unordered_map< FaceCRef, Vec3 > fp;
	for (FaceCRef f = faces.begin(); f != faces.end(); f++) if (!f->boundary) fp.emplace(f, f->center());
	for (EdgeCRef e = edges.begin(); e != edges.end(); e++) {
		if (e->on_boundary()) { ep[e] = e->center(); continue; }
		ep[e] = (2.0f * e->center() + fp.at(e->halfedge->face) + fp.at(e->halfedge->twin->face)) / 4.0f;
	}
	for (VertexRef v = vertices.begin(); v != vertices.end(); v++) {
		Vec3 q, r, rim;
		float n = 0.0f;
		bool open = false;
		for (auto s : v->spokes()) {
			n += 1.0f;
			r += s->edge->center();
			if (s->edge->on_boundary()) { open = true; rim += s->twin->vertex->position; }
			if (!s->face->boundary) q += fp.at(s->face);
		}
		if (open) vp[v] = 0.75f * v->position + 0.125f * rim;
		else vp[v] = (q / n + 2.0f * r / n + (n - 3.0f) * v->position) / n;
	}
	catmark_subdivide_helper(vp, ep, fp);
}

bool Halfedge_Mesh::loop_subdivide() {
	for (FaceRef f = faces.begin(); f != faces.end(); f++)
		if (!f->boundary && f->sides().size() != 3) return false;
	std::unordered_map< VertexRef, Vec3 > old_to;
	std::unordered_map< EdgeRef, Vec3 > mid;
	for (VertexRef v = vertices.begin(); v != vertices.end(); v++) {
		Vec3 sum, rim;
		float n = 0;
		bool open = false;
		for (auto s : v->spokes()) {
			n++;
			sum += s->twin->vertex->position;
			if (s->edge->on_boundary()) { open = true; rim += s->twin->vertex->position; }
		}
		float u = n == 3 ? 3.0f / 16.0f : 3.0f / (8.0f * n);
		old_to[v] = open ? 0.75f * v->position + 0.125f * rim : (1.0f - n * u) * v->position + u * sum;
	}
	std::vector<EdgeRef> old;
	for (EdgeRef e = edges.begin(); e != edges.end(); e++) {
		old.push_back(e);
		HalfedgeRef h = e->halfedge, t = h->twin;
		if (e->on_boundary()) { mid[e] = e->center(); continue; }
		mid[e] = 0.75f * e->center() + 0.125f * (h->next->next->vertex->position + t->next->next->vertex->position);
	}
	std::set<Index> young;                   // vertices
	std::vector<EdgeRef> cuts;
	for (auto e : old) {
		VertexRef v = *split_edge(e);
		v->position = mid[e];
		young.insert(v->id);
		// the two ways along the old edge lead to old vertices that it had
		std::vector<EdgeRef> sides;
		for (auto s : v->spokes()) sides.push_back(s->edge);
		HalfedgeRef along = v->halfedge;     // one half of e
		HalfedgeRef other = along;
		size_t n = sides.size();
		for (size_t i = 0; i < (n == 4 ? 2 : 0); i++) other = other->twin->next;
		if (n == 3) {
			// at the boundary the other half is the one that is on it as well
			for (auto s : v->spokes()) if (s != along && s->edge->on_boundary()) other = s;
		}
		for (auto s : v->spokes()) if (s != along && s != other) cuts.push_back(s->edge);
	}
	for (auto c : cuts) {
		bool a = young.count(c->halfedge->vertex->id), b = young.count(c->halfedge->twin->vertex->id);
		if (a != b) flip_edge(c);
	}
	for (auto& [v, p] : old_to) v->position = p;
	return true;
}

void Halfedge_Mesh::isotropic_remesh(Isotropic_Remesh_Parameters const &params) {
	auto all = [&]() {
		std::vector< std::pair< EdgeRef, Index > > list;
		for (EdgeRef e = edges.begin(); e != edges.end(); e++) list.emplace_back(e, e->id);
		return list;
	};
	for (uint32_t round = 0; round < params.outer_iterations; round++) {
		float mean = 0.0f;
		for (EdgeRef e = edges.begin(); e != edges.end(); e++) mean += e->length() / float(edges.size());
		for (auto [e, id] : all()) {
			if (e->length() > params.longer_factor * mean) split_edge(e);
		}
		for (auto [e, id] : all()) {
			// erased elements get another id
			if (e->id == id && e->length() < params.shorter_factor * mean) collapse_edge(e);
		}
		for (auto [e, id] : all()) {
			if (e->on_boundary()) continue;
			HalfedgeRef h = e->halfedge, t = h->twin;
			auto off = [](VertexRef v, int more) { return std::abs(int(v->degree()) + more - 6); };
			VertexRef a = h->vertex, b = t->vertex, c = h->next->next->vertex, d = t->next->next->vertex;
			int now = off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0);
			int then = off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1);
			if (then < now) flip_edge(e);
		}
		for (uint32_t i = 0; i < params.smoothing_iterations; i++) {
			std::unordered_map< VertexRef, Vec3 > to;
			for (VertexRef v = vertices.begin(); v != vertices.end(); v++) {
				Vec3 n = v->normal();
				Vec3 u = v->neighborhood_center() - v->position;
				to[v] = v->position + params.smoothing_step * (u - dot(u, n) * n);
			}
			for (auto& [v, p] : to) v->position = p;
		}
	}
}

struct Edge_Record {
	Edge_Record(std::unordered_map<Halfedge_Mesh::VertexCRef, Mat4>& vertex_quadrics, Halfedge_Mesh::EdgeRef e) : edge(e) {
		Vec3 a = e->halfedge->vertex->position, b = e->halfedge->twin->vertex->position;
		Mat4 K = vertex_quadrics.at(e->halfedge->vertex) + vertex_quadrics.at(e->halfedge->twin->vertex);
		Mat4 A = K;
		A[0].w = A[1].w = A[2].w = 0.0f;
		A[3] = Vec4(0.0f, 0.0f, 0.0f, 1.0f);
		optimal = 0.5f * (a + b);
		if (std::abs(A.det()) > 1e-3f) {
			optimal = A.inverse() * Vec3(-K[3].x, -K[3].y, -K[3].z);
		} else {
			for (Vec3 p : {a, b}) if (price(K, p) < price(K, optimal)) optimal = p;
		}
		cost = price(K, optimal);
	}
	static float price(const Mat4& K, const Vec3& p) { return dot(Vec4(p, 1.0f), K * Vec4(p, 1.0f)); }
	Halfedge_Mesh::EdgeRef edge;
	Vec3 optimal;
	float cost;
};

bool operator<(const Edge_Record& r1, const Edge_Record& r2) {
	if (r1.cost != r2.cost) return r1.cost < r2.cost;
	return r1.edge->id < r2.edge->id;
}

bool Halfedge_Mesh::simplify(float ratio) {
	std::unordered_map< VertexCRef, Mat4 > vertex_quadrics;
	size_t n_faces = 0;
	for (VertexRef v = vertices.begin(); v != vertices.end(); v++) vertex_quadrics[v] = Mat4::Zero;
	for (FaceRef f = faces.begin(); f != faces.end(); f++) {
		if (f->boundary) continue;
		n_faces++;
		Vec3 n = f->normal();
		Vec4 plane(n, -dot(n, f->halfedge->vertex->position));
		for (HalfedgeRef s : f->sides()) vertex_quadrics[s->vertex] += outer(plane, plane);
	}
	std::set< Edge_Record > queue;
	std::unordered_map< EdgeRef, Edge_Record > records;
	auto take_out = [&](EdgeRef e) {
		auto r = records.find(e);
		if (r == records.end()) return;
		queue.erase(r->second);
		records.erase(r);
	};
	auto put_in = [&](EdgeRef e) {
		Edge_Record r(vertex_quadrics, e);
		queue.insert(r);
		records.emplace(e, r);
	};
	for (EdgeRef e = edges.begin(); e != edges.end(); e++) put_in(e);
	size_t goal = size_t(ratio * n_faces), left = n_faces;
	while (left > goal) {
		if (queue.empty()) return false;
		Edge_Record best = *queue.begin();
		VertexRef a = best.edge->halfedge->vertex, b = best.edge->halfedge->twin->vertex;
		Mat4 K = vertex_quadrics[a] + vertex_quadrics[b];
		std::vector< EdgeRef > around;
		for (VertexRef v : {a, b}) for (HalfedgeRef s : v->spokes()) around.push_back(s->edge);
		bool rim = best.edge->on_boundary();
		std::vector< EdgeRef > was_in;
		for (EdgeRef e : around) if (records.count(e)) { was_in.push_back(e); take_out(e); }
		auto v = collapse_edge(best.edge);
		if (!v) {
			for (EdgeRef e : was_in) if (e != best.edge) put_in(e);
			continue;
		}
		left -= rim ? 1 : 2;
		(*v)->position = best.optimal;
		vertex_quadrics[*v] = K;
		for (HalfedgeRef s : (*v)->spokes()) { take_out(s->edge); put_in(s->edge); }
	}
	return true;
}

// provided
void Halfedge_Mesh::catmark_subdivide_helper(
	std::unordered_map< VertexCRef, Vec3 > const &vertex_positions,
	std::unordered_map< EdgeCRef, Vec3 > const &edge_vertex_positions,
	std::unordered_map< FaceCRef, Vec3 > const &face_vertex_positions) {
	for (VertexRef v = vertices.begin(); v != vertices.end(); v++) v->position = vertex_positions.at(v);
	(void)edge_vertex_positions; (void)face_vertex_positions;
}
