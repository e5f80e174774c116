#include "halfedge.h"

#include <unordered_map>
#include <unordered_set>
#include <functional>
#include <iostream>
#include <numeric>

/* Local operations, written with lists of half-edges: collect first, check, then rewire. */

namespace {

using HRef = Halfedge_Mesh::HalfedgeRef;
using VRef = Halfedge_Mesh::VertexRef;

// all half-edges of the loop of h, beginning with h
std::vector<HRef> loop_of(HRef h) {
	std::vector<HRef> all;
	HRef at = h;
	do {
		all.emplace_back(at);
		at = at->next;
	} while (at != h);
	return all;
}

// all half-edges that leave v
std::vector<HRef> out_of(VRef v) {
	std::vector<HRef> all;
	HRef at = v->halfedge;
	do {
		all.emplace_back(at);
		at = at->twin->next;
	} while (at != v->halfedge);
	return all;
}

HRef before(HRef h) {
	return loop_of(h).back();
}

bool has_corner(HRef h, VRef v) {
	for (HRef k : loop_of(h)) if (k->vertex == v) return true;
	return false;
}

// chains the half-edges into one loop of the face
void chain(std::vector<HRef> const &loop, Halfedge_Mesh::FaceRef f) {
	for (size_t i = 0; i < loop.size(); ++i) {
		loop[i]->next = loop[(i + 1) % loop.size()];
		loop[i]->face = f;
	}
	f->halfedge = loop.front();
}

} // namespace

//provided by the course: a face from corners (here only so far as to be in the way)
Halfedge_Mesh::FaceRef Halfedge_Mesh::add_face(std::vector< VertexRef > const &corners, bool boundary) {
	FaceRef f = emplace_face(boundary);
	for (auto const &c : corners) {
		HalfedgeRef h = emplace_halfedge();
		h->vertex = c;
		h->face = f;
	}
	return f;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::bisect_edge(EdgeRef e) {
	HalfedgeRef h = e->halfedge, t = h->twin;
	VertexRef m = emplace_vertex();
	m->position = e->center();
	interpolate_data({h->vertex, t->vertex}, m);

	EdgeRef e2 = emplace_edge(e->sharp);
	HalfedgeRef h2 = emplace_halfedge();
	HalfedgeRef t2 = emplace_halfedge();
	// h: a -> m, h2: m -> b; t: b -> m, t2: m -> a
	h2->set_tnvef(t, h->next, m, e2, h->face);
	t2->set_tnvef(h, t->next, m, e, t->face);
	h->next = h2; h->twin = t2;
	t->next = t2; t->twin = h2; t->edge = e2;
	interpolate_data({h, h2->next}, h2);
	m->halfedge = t2;
	e->halfedge = h;
	e2->halfedge = h2;
	return m;
}

std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(EdgeRef e) {
	if (e->on_boundary()) return std::nullopt;
	HalfedgeRef h = e->halfedge, t = h->twin;
	VertexRef c = h->next->twin->vertex;
	VertexRef d = t->next->twin->vertex;
	if (has_corner(h, d) || has_corner(t, c)) return std::nullopt;

	std::vector<HalfedgeRef> f = loop_of(h), g = loop_of(t);
	// h gives its next one to the other side and takes that of t
	std::vector<HalfedgeRef> nf(f.begin() + 2, f.end()), ng(g.begin() + 2, g.end());
	nf.push_back(g[1]);
	ng.push_back(f[1]);
	h->vertex->halfedge = g[1];
	t->vertex->halfedge = f[1];
	nf.insert(nf.begin(), h);
	ng.insert(ng.begin(), t);
	h->vertex = d;
	t->vertex = c;
	chain(nf, h->face);
	chain(ng, t->face);
	return e;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::split_edge(EdgeRef e) {
	std::optional<VertexRef> got = bisect_edge(e);
	VertexRef m = got.value();
	HalfedgeRef along = m->halfedge;
	for (HalfedgeRef h : out_of(m)) {
		if (h->face->boundary) continue;
		// cut off the triangle m, end of h, and the corner after that
		std::vector<HalfedgeRef> loop = loop_of(h);
		EdgeRef cut = emplace_edge();
		HalfedgeRef in = emplace_halfedge(), out = emplace_halfedge();
		FaceRef small = emplace_face();
		cut->halfedge = in;
		in->twin = out; out->twin = in;
		in->edge = out->edge = cut;
		in->vertex = loop[2]->vertex;
		out->vertex = m;
		chain({loop[0], loop[1], in}, small);
		std::vector<HalfedgeRef> rest(loop.begin() + 2, loop.end());
		rest.push_back(out);
		chain(rest, h == along ? loop[2]->face : loop[2]->face);
	}
	return m;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::collapse_edge(EdgeRef e) {
	HalfedgeRef h = e->halfedge, t = h->twin;
	VertexRef a = h->vertex, b = t->vertex;
	if (a->on_boundary() && b->on_boundary() && !e->on_boundary()) return std::nullopt;
	std::unordered_set<VertexRef> tips;
	for (HalfedgeRef side : {h, t}) {
		if (loop_of(side).size() > 3) continue;
		if (side->face->boundary) return std::nullopt;
		VertexRef tip = side->next->next->vertex;
		if (tip->degree() < 3) return std::nullopt;
		tips.insert(tip);
	}
	// the link condition, and no other face with both ends
	std::unordered_set<VertexRef> near_b;
	for (HalfedgeRef k : out_of(b)) near_b.insert(k->twin->vertex);
	for (HalfedgeRef k : out_of(a)) {
		VertexRef n = k->twin->vertex;
		if (near_b.count(n) && !tips.count(n)) return std::nullopt;
		if (k->face == h->face || k->face == t->face || k->face->boundary) continue;
		if (has_corner(k, b)) return std::nullopt;
	}

	// a new vertex takes the place of both
	VertexRef m = emplace_vertex();
	m->position = (a->position + b->position) / 2.0f;
	interpolate_data({a, b}, m);
	for (HalfedgeRef k : out_of(a)) k->vertex = m;
	for (HalfedgeRef k : out_of(b)) k->vertex = m;
	for (HalfedgeRef side : {h, t}) {
		HalfedgeRef last = before(side);
		last->next = side->next;
		last->face->halfedge = last;
		m->halfedge = side->next;
	}
	for (HalfedgeRef side : {h, t}) {
		HalfedgeRef x = side->next, y = x->next;
		if (y->next != x) continue;
		// a face of two sides goes, with x and the edge of y
		HalfedgeRef p = x->twin, q = y->twin;
		EdgeRef keep = x->edge;
		p->twin = q; q->twin = p;
		q->edge = keep;
		keep->halfedge = p;
		p->vertex->halfedge = p;
		q->vertex->halfedge = q;
		erase_edge(y->edge);
		erase_face(x->face);
		erase_halfedge(x);
		erase_halfedge(y);
	}
	erase_halfedge(h);
	erase_halfedge(t);
	erase_edge(e);
	erase_vertex(a);
	erase_vertex(b);
	return m;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::dissolve_edge(EdgeRef e) {
	HalfedgeRef h = e->halfedge, t = h->twin;
	if (t->face->boundary) std::swap(h, t); // so that what is outside goes on living
	if (h->vertex->degree() < 3 || t->vertex->degree() < 3) return std::nullopt;
	std::unordered_set<VertexRef> of_h;
	for (HalfedgeRef k : loop_of(h)) of_h.insert(k->vertex);
	std::vector<HalfedgeRef> merged = loop_of(h), rest = loop_of(t);
	for (size_t i = 2; i < rest.size(); ++i)
		if (of_h.count(rest[i]->vertex)) return std::nullopt;
	if (h->face->boundary) {
		// nothing else of the face may touch a boundary
		for (size_t i = 2; i < rest.size(); ++i)
			if (rest[i]->vertex->on_boundary()) return std::nullopt;
	}
	merged.erase(merged.begin());
	merged.insert(merged.end(), rest.begin() + 1, rest.end());
	h->vertex->halfedge = rest[1];
	t->vertex->halfedge = merged[0];
	FaceRef f = h->face;
	erase_face(t->face);
	erase_edge(e);
	erase_halfedge(h);
	erase_halfedge(t);
	chain(merged, f);
	return f;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::dissolve_vertex(VertexRef v) {
	std::vector<HalfedgeRef> spokes = out_of(v);
	// turn so that the one of the boundary comes last
	for (size_t i = 0; i < spokes.size(); ++i) {
		if (!spokes[i]->face->boundary) continue;
		std::rotate(spokes.begin(), spokes.begin() + i + 1, spokes.end());
		break;
	}
	bool open = spokes.back()->face->boundary;
	std::vector<HalfedgeRef> outline; // against the order of the spokes
	for (HalfedgeRef s : spokes) {
		if (s->face->boundary) continue;
		std::vector<HalfedgeRef> loop = loop_of(s);
		outline.insert(outline.begin(), loop.begin() + 1, loop.end() - 1);
	}
	if (outline.empty()) return std::nullopt;
	std::unordered_set<VertexRef> corners;
	for (HalfedgeRef k : outline) if (!corners.insert(k->vertex).second) return std::nullopt;
	VertexRef first = outline.front()->vertex, last = outline.back()->twin->vertex;
	if (open) {
		if (!corners.insert(last).second) return std::nullopt;
	} else if (first != last) {
		return std::nullopt;
	}
	if (corners.size() < 3) return std::nullopt;
	if (open && loop_of(spokes.back()).size() == 3) return std::nullopt;

	for (HalfedgeRef k : outline) k->vertex->halfedge = k;
	FaceRef f = emplace_face();
	if (open) {
		// the way around outside is cut short by a new edge
		HalfedgeRef out = spokes.back(), in = before(out);
		EdgeRef cut = emplace_edge();
		HalfedgeRef inner = emplace_halfedge(), outer = emplace_halfedge();
		FaceRef hole = out->face;
		outer->set_tnvef(inner, out->next, first, cut, hole);
		// outside goes from `in` to v and from there along `out`
		outer->vertex = in->vertex;
		inner->set_tnvef(outer, outline.front(), last, cut, f);
		cut->halfedge = inner;
		before(in)->next = outer;
		hole->halfedge = outer;
		last->halfedge = inner;
		outer->vertex->halfedge = outer;
		outline.push_back(inner);
	}
	for (HalfedgeRef s : spokes) {
		if (!s->face->boundary) erase_face(s->face);
	}
	for (HalfedgeRef s : spokes) {
		HalfedgeRef back = s->twin;
		erase_edge(s->edge);
		erase_halfedge(s);
		erase_halfedge(back);
	}
	erase_vertex(v);
	chain(outline, f);
	return f;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::inset_vertex(FaceRef f) {
	if (f->boundary) return std::nullopt;
	std::vector<HalfedgeRef> sides = loop_of(f->halfedge);
	VertexRef m = emplace_vertex();
	m->position = f->center();
	std::vector<HalfedgeRef> in, out;
	for (size_t i = 0; i < sides.size(); ++i) {
		EdgeRef e = emplace_edge();
		HalfedgeRef to = emplace_halfedge(), from = emplace_halfedge();
		to->vertex = sides[i]->vertex;
		from->vertex = m;
		to->twin = from; from->twin = to;
		to->edge = from->edge = e;
		e->halfedge = to;
		in.push_back(to);
		out.push_back(from);
	}
	m->halfedge = out[0];
	for (size_t i = 0; i < sides.size(); ++i) {
		FaceRef small = i == 0 ? f : emplace_face();
		chain({sides[i], in[(i + 1) % sides.size()], out[i]}, small);
	}
	return m;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::extrude_face(FaceRef f) {
	if (f->boundary) return std::nullopt;
	std::vector<HalfedgeRef> outer = loop_of(f->halfedge), inner;
	const size_t n = outer.size();
	std::vector<VertexRef> tops;
	for (HalfedgeRef h : outer) {
		VertexRef v = emplace_vertex();
		v->position = h->vertex->position;
		interpolate_data({h->vertex}, v);
		tops.push_back(v);
	}
	std::vector<HalfedgeRef> up, down;
	for (size_t i = 0; i < n; ++i) {
		EdgeRef e = emplace_edge();
		up.push_back(emplace_halfedge());
		down.push_back(emplace_halfedge());
		up[i]->vertex = outer[i]->vertex;
		down[i]->vertex = tops[i];
		up[i]->twin = down[i]; down[i]->twin = up[i];
		up[i]->edge = down[i]->edge = e;
		e->halfedge = up[i];
	}
	for (size_t i = 0; i < n; ++i) {
		const size_t j = (i + 1) % n;
		EdgeRef e = emplace_edge();
		HalfedgeRef in = emplace_halfedge(), back = emplace_halfedge();
		in->vertex = tops[i];
		back->vertex = tops[j];
		in->twin = back; back->twin = in;
		in->edge = back->edge = e;
		e->halfedge = in;
		tops[i]->halfedge = in;
		chain({outer[i], up[j], back, down[i]}, emplace_face());
		inner.push_back(in);
	}
	chain(inner, f);
	return f;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::bevel_vertex(VertexRef v) {
	std::vector<HalfedgeRef> spokes = out_of(v);
	if (spokes.size() < 3) return std::nullopt;
	FaceRef f = emplace_face();
	std::vector<HalfedgeRef> inner;
	// v itself stays, as the corner of the first spoke
	for (size_t i = 1; i < spokes.size(); ++i) {
		VertexRef u = emplace_vertex();
		u->position = v->position;
		spokes[i]->vertex = u;
		u->halfedge = spokes[i];
	}
	v->halfedge = spokes[0];
	for (size_t i = 0; i < spokes.size(); ++i) {
		HalfedgeRef to = spokes[(i + 1) % spokes.size()];
		EdgeRef e = emplace_edge();
		HalfedgeRef out = emplace_halfedge(), in = emplace_halfedge();
		out->set_tnvef(in, to, spokes[i]->vertex, e, to->face);
		in->set_tnvef(out, in, to->vertex, e, f);
		e->halfedge = in;
		spokes[i]->twin->next = out;
		inner.insert(inner.begin(), in);
	}
	chain(inner, f);
	return f;
}

void Halfedge_Mesh::extrude_positions(FaceRef face, Vec3 move, float shrink) {
	std::vector<HalfedgeRef> ring = loop_of(face->halfedge);
	std::vector<Vec3> base;
	for (HalfedgeRef h : ring) base.push_back(before(h->twin)->vertex->position);
	// before(h->twin) starts at the outer corner of where h ends: turn by one
	std::rotate(base.begin(), base.end() - 1, base.end());
	Vec3 center = std::accumulate(base.begin(), base.end(), Vec3{}) / float(base.size());
	for (size_t i = 0; i < ring.size(); ++i)
		ring[i]->vertex->position = (1.0f - shrink) * base[i] + shrink * center + move;
}
