#include "halfedge.h"

#include <queue>
#include <unordered_map>

// Cuts off one corner after the other, from a list of the old faces.
void Halfedge_Mesh::triangulate() {
	std::queue<FaceRef> todo;
	for (FaceRef f = faces.begin(); f != faces.end(); ++f) if (!f->boundary) todo.push(f);
	while (!todo.empty()) {
		FaceRef f = todo.front();
		todo.pop();
		if (f->degree() == 3) continue;
		HalfedgeRef a = f->halfedge, b = a->next, c = b->next;
		HalfedgeRef last = c;
		while (last->next != a) last = last->next;
		EdgeRef e = emplace_edge();
		HalfedgeRef in = emplace_halfedge(), out = emplace_halfedge();
		FaceRef tri = emplace_face();
		in->set_tnvef(out, a, c->vertex, e, tri);
		out->set_tnvef(in, c, a->vertex, e, f);
		e->halfedge = out;
		b->next = in;
		a->face = b->face = tri;
		tri->halfedge = in;
		last->next = out;
		f->halfedge = out;
		a->vertex->halfedge = out;
		todo.push(f); // it may be too large still
	}
}

void Halfedge_Mesh::catmark_subdivide() {
	std::unordered_map< VertexCRef, Vec3 > vertex_positions;
	std::unordered_map< EdgeCRef, Vec3 > edge_vertex_positions;
	std::unordered_map< FaceCRef, Vec3 > face_vertex_positions;

	for (FaceCRef f = faces.begin(); f != faces.end(); ++f) {
		if (f->boundary) continue;
		face_vertex_positions[f] = f->center();
	}
	// every half-edge adds its part to the edge and to where it starts
	std::unordered_map< VertexCRef, Vec3 > q, r, rim;
	std::unordered_map< VertexCRef, int > n, on_rim;
	for (HalfedgeCRef h = halfedges.begin(); h != halfedges.end(); ++h) {
		Vec3 middle = (h->vertex->position + h->twin->vertex->position) / 2.0f;
		r[h->vertex] += middle;
		n[h->vertex] += 1;
		if (h->face->boundary || h->twin->face->boundary) {
			rim[h->vertex] += h->twin->vertex->position;
			on_rim[h->vertex] += 1;
			edge_vertex_positions[h->edge] = middle;
		} else {
			edge_vertex_positions[h->edge] += (h->vertex->position + face_vertex_positions[h->face]) / 4.0f;
		}
		if (!h->face->boundary) q[h->vertex] += face_vertex_positions[h->face];
	}
	for (VertexCRef v = vertices.begin(); v != vertices.end(); ++v) {
		if (on_rim[v] == 2) {
			vertex_positions[v] = (6.0f * v->position + rim[v]) / 8.0f;
			continue;
		}
		float d = float(n[v]);
		vertex_positions[v] = (q[v] + 2.0f * r[v]) / (d * d) + v->position * ((d - 3.0f) / d);
	}
	catmark_subdivide_helper(vertex_positions, edge_vertex_positions, face_vertex_positions);
}
