#include "halfedge.h"
#include <set>
#include <algorithm>
#include <iostream>
#include "../lib/log.h"

using std::optional;
using std::vector;

/* ---- small helpers that I added to the header ---- */

Halfedge_Mesh::HalfedgeRef Halfedge_Mesh::Halfedge::prev() {
	HalfedgeRef h = next;
	while (h->next->id != id) h = h->next;
	return h;
}

vector<Halfedge_Mesh::HalfedgeRef> Halfedge_Mesh::Vertex::spokes() {
	vector<HalfedgeRef> all{halfedge};
	for (HalfedgeRef h = halfedge->twin->next; h != halfedge; h = h->twin->next) all.push_back(h);
	return all;
}

void Halfedge_Mesh::pair_up(HalfedgeRef a, HalfedgeRef b, EdgeRef e) {
	a->twin = b; b->twin = a;
	a->edge = e; b->edge = e;
	e->halfedge = a;
}

// x and x->next are all of a face: make one edge of their edges
void Halfedge_Mesh::close_two_gon(HalfedgeRef x) {
	HalfedgeRef y = x->next;
	HalfedgeRef p = x->twin, q = y->twin;
	EdgeRef keep = y->edge;
	erase_edge(x->edge);
	pair_up(p, q, keep);
	p->vertex->halfedge = p;
	q->vertex->halfedge = q;
	erase_face(x->face);
	erase_halfedge(x); erase_halfedge(y);
}

// a new edge inside of a face, from the start of `from` to the start of `to`; the part that
// begins with `to` and comes back to `from` becomes `beside`
Halfedge_Mesh::EdgeRef Halfedge_Mesh::link(HalfedgeRef from, HalfedgeRef to, FaceRef beside) {
	HalfedgeRef before_from = from->prev(), before_to = to->prev();
	EdgeRef e = emplace_edge();
	HalfedgeRef h = emplace_halfedge(), t = emplace_halfedge();
	FaceRef f = from->face;
	h->vertex = from->vertex; t->vertex = to->vertex;
	pair_up(h, t, e);
	before_from->next = h; h->next = to;
	before_to->next = t; t->next = from;
	f->halfedge = t; t->face = f;
	beside->halfedge = h;
	HalfedgeRef k = h;
	do { k->face = beside; k = k->next; } while (k != h);
	return e;
}

// every spoke gets a start of its own, and a face is put between these; the spokes are in the
// order in which twin->next finds them
Halfedge_Mesh::FaceRef Halfedge_Mesh::cut_round(const vector<HalfedgeRef>& spokes) {
	FaceRef f = emplace_face();
	size_t n = spokes.size();
	vector<HalfedgeRef> in;
	for (auto s : spokes) {
		VertexRef u = emplace_vertex();
		u->position = s->vertex->position;
		s->vertex = u;
		u->halfedge = s;
	}
	for (size_t i = 0; i < n; i++) {
		HalfedgeRef s = spokes[i], z = spokes[(i + 1) % n];
		HalfedgeRef a = emplace_halfedge(), b = emplace_halfedge();
		pair_up(a, b, emplace_edge());
		a->set_tnvef(b, z, s->vertex, a->edge, z->face);
		b->vertex = z->vertex;
		b->face = f;
		s->twin->next = a;
		z->face->halfedge = a;
		in.push_back(b);
	}
	for (size_t i = 0; i < n; i++) in[i]->next = in[(i + n - 1) % n];
	f->halfedge = in[0];
	return f;
}

/* ---- the homework ---- */

optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(EdgeRef e) {
	HalfedgeRef h = e->halfedge, t = h->twin;
	if (h->outside() || t->outside()) return std::nullopt;
	HalfedgeRef hp = h->prev(), tp = last_of(t), hn = h->next, tn = t->next;
	for (auto k : h->face->sides()) if (k->vertex == tn->next->vertex) return std::nullopt;
	for (auto k : t->face->sides()) if (k->vertex == hn->next->vertex) return std::nullopt;
	if (h->vertex->halfedge == h) h->vertex->halfedge = tn;
	if (t->vertex->halfedge == t) t->vertex->halfedge = hn;
	h->vertex = tn->next->vertex;
	t->vertex = hn->next->vertex;
	h->face->halfedge = h;
	t->face->halfedge = t;
	h->next = hn->next; t->next = tn->next;
	hp->next = tn; tn->next = h; tn->face = h->face;
	tp->next = hn; hn->next = t; hn->face = t->face;
	return e;
}

optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::split_edge(EdgeRef e) {
	HalfedgeRef h = e->halfedge, t = h->twin;
	VertexRef m = emplace_vertex();
	m->position = e->center();
	EdgeRef e2 = emplace_edge(e->sharp);
	HalfedgeRef h2 = emplace_halfedge(), t2 = emplace_halfedge();
	h2->next = h->next; h2->vertex = m; h2->face = h->face; h->next = h2;
	t2->next = t->next; t2->vertex = m; t2->face = t->face; t->next = t2;
	pair_up(h, t2, e);
	pair_up(h2, t, e2);
	m->halfedge = h2;
	for (HalfedgeRef s : {h2, t2}) {
		if (s->outside()) continue;
		link(s, s->next->next, emplace_face());
	}
	return m;
}

optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::collapse_edge(EdgeRef e) {
	HalfedgeRef h = e->halfedge, t = h->twin;
	VertexRef a = h->vertex, b = t->vertex;
	if (a->on_boundary() && b->on_boundary() && !h->outside() && !t->outside()) return std::nullopt;
	std::set<VertexRef> ends;
	for (auto s : {h, t}) {
		if (s->face->sides().size() > 3) continue;
		auto apex = s->prev()->vertex;
		if (s->outside() || apex->degree() == 2) return std::nullopt;
		ends.insert(apex);
	}
	std::set<VertexRef> near;
	for (auto s : a->spokes()) near.insert(s->twin->vertex);
	for (auto s : b->spokes()) {
		VertexRef v = s->twin->vertex;
		if (near.find(v) != near.end() && ends.find(v) == ends.end()) return std::nullopt;
		if (s->outside() || s->face == h->face || s->face == t->face) continue;
		for (auto k : s->face->sides()) if (k->vertex == a) return std::nullopt;
	}
	b->position = e->center();
	for (auto s : a->spokes()) s->vertex = b;
	for (auto s : {h, t}) {
		HalfedgeRef p = s->prev();
		p->next = s->next;
		s->face->halfedge = p;
	}
	b->halfedge = h->next;
	vector<HalfedgeRef> rest{h->next, t->next};
	for (auto x : rest) if (x->next->next == x) close_two_gon(x);
	erase_vertex(a);
	erase_edge(e);
	erase_halfedge(h);
	erase_halfedge(t);
	return b;
}

optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::dissolve_edge(EdgeRef e) {
	HalfedgeRef h = e->halfedge, t = h->twin;
	if (h->outside()) std::swap(h, t);   // h is inside
	FaceRef go = h->face, stay = t->face;
	// how many corners have the two in common?
	std::set<VertexRef> corners;
	int shared = 0;
	for (auto k : go->sides()) corners.insert(k->vertex);
	for (auto k : stay->sides()) shared += (int)corners.count(k->vertex);
	if (shared > 2) return std::nullopt;
	if (h->vertex->degree() < 3 || t->vertex->degree() < 3) return std::nullopt;
	if (stay->boundary) {
		for (auto k : go->sides())
			if (k->vertex != h->vertex && k->vertex != t->vertex && k->vertex->on_boundary()) return std::nullopt;
	}
	HalfedgeRef hp = h->prev(), tp = t->prev();
	hp->next = t->next;
	tp->next = h->next;
	for (HalfedgeRef k = h->next; k != t->next; k = k->next) k->face = stay;
	h->vertex->halfedge = t->next;
	t->vertex->halfedge = h->next;
	stay->halfedge = tp;
	erase_edge(e);
	erase_face(go);
	erase_halfedge(h); erase_halfedge(t);
	return stay;
}

// the sides that do not touch v, put in order by where they start
optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::dissolve_vertex(VertexRef v) {
	HalfedgeRef out = halfedges.end();
	std::multiset<Index> outline;
	for (auto s : v->spokes()) {
		if (s->outside()) { out = s; continue; }
		for (auto k : s->face->sides())
			if (k->vertex != v && k->next->vertex != v) outline.insert(k->vertex->id);
	}
	bool open = out != halfedges.end();
	if (open) outline.insert(out->twin->vertex->id);
	for (auto id : outline) if (outline.count(id) > 1) return std::nullopt;
	if (outline.size() < 3) return std::nullopt;
	if (open && (v->degree() == 2 || out->face->sides().size() == 3)) return std::nullopt;

	// at a boundary, v is cut off by an edge first, and then lies inside
	if (open) link(out->next, out->prev(), emplace_face());
	std::map<VertexRef, HalfedgeRef> rim;
	auto spokes = v->spokes();
	for (auto s : spokes)
		for (auto k : s->face->sides())
			if (k->vertex != v && k->next->vertex != v) rim[k->vertex] = k;
	FaceRef f = emplace_face();
	for (auto& [start, k] : rim) {
		start->halfedge = k;
		k->face = f;
		f->halfedge = k;
	}
	for (auto& start_and_k : rim) {
		HalfedgeRef k = start_and_k.second;
		k->next = rim.at(k->twin->vertex);
	}
	for (auto s : spokes) {
		HalfedgeRef back = s->twin;
		erase_face(s->face);
		erase_edge(s->edge);
		erase_halfedge(s); erase_halfedge(back);
	}
	erase_vertex(v);
	return f;
}

optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::inset_vertex(FaceRef f) {
	if (f->boundary) return std::nullopt;
	auto sides = f->sides();
	VertexRef m = emplace_vertex();
	m->position = Vec3{0.0f, 0.0f, 0.0f};
	for (auto s : sides) m->position += s->vertex->position / float(sides.size());
	// a first spoke that ends inside, then the others by links
	EdgeRef e = emplace_edge();
	HalfedgeRef in = emplace_halfedge(), out = emplace_halfedge();
	pair_up(in, out, e);
	HalfedgeRef p = sides[0]->prev();
	in->vertex = sides[0]->vertex; out->vertex = m;
	in->face = out->face = f;
	p->next = in; in->next = out; out->next = sides[0];
	m->halfedge = out;
	for (size_t i = 1; i < sides.size(); i++) link(m->halfedge, sides[i], emplace_face()), m->halfedge = sides[i]->prev();
	m->mark++;
	return m;
}

optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::extrude_face(FaceRef f) {
	auto sides = f->sides();
	FaceRef inner = emplace_face();
	std::vector<HalfedgeRef> ring, ins, outs;
	for (auto s : sides) {
		VertexRef v = emplace_vertex();
		v->position = s->vertex->position;
		HalfedgeRef a = emplace_halfedge(), b = emplace_halfedge();
		a->vertex = s->vertex; b->vertex = v;
		pair_up(a, b, emplace_edge());
		v->halfedge = b;
		ins.push_back(a); outs.push_back(b);
	}
	for (size_t i = 0; i < sides.size(); i++) {
		size_t j = (i + 1) % sides.size();
		HalfedgeRef a = emplace_halfedge(), b = emplace_halfedge();
		pair_up(a, b, emplace_edge());
		a->vertex = outs[i]->vertex; b->vertex = outs[j]->vertex;
		FaceRef q = i == 0 ? f : emplace_face();
		sides[i]->next = ins[j]; ins[j]->next = b; b->next = outs[i]; outs[i]->next = sides[i];
		for (auto k : {sides[i], ins[j], b, outs[i]}) k->face = q;
		q->halfedge = outs[i];
		a->face = inner;
		ring.push_back(a);
	}
	for (size_t i = 0; i < ring.size(); i++) ring[i]->next = ring[(i + 1) % ring.size()];
	inner->halfedge = ring[0];
	return inner;
}

optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::collapse_face(FaceRef f) {
	if (f->boundary) return std::nullopt;
	auto sides = f->sides();
	std::set<VertexRef> mine;
	for (auto s : sides) mine.insert(s->vertex);
	// the boundary: one run at most, and enough of it left
	size_t touching = 0, along = 0;
	for (auto s : sides) {
		touching += s->vertex->on_boundary();
		along += s->twin->outside();
	}
	if (touching > along + 1) return std::nullopt;
	for (auto s : sides)
		if (s->twin->outside() && s->twin->face->sides().size() < along + 3) return std::nullopt;
	// the faces around: each comes to me once and by my own sides only
	std::map<Index, FaceRef> faces_around;
	vector<HalfedgeRef> leaving;
	for (auto s : sides)
		for (auto k : s->vertex->spokes()) {
			if (!k->outside() && k->face != f) faces_around[k->face->id] = k->face;
			if (!mine.count(k->twin->vertex)) leaving.push_back(k);
		}
	if (leaving.empty()) return std::nullopt;
	std::map<VertexRef, uint32_t> ears, edges_to;
	for (auto& [id, g] : faces_around) {
		(void)id;
		int runs = 0, others = 0;
		VertexRef other = vertices.end();
		for (auto k : g->sides()) {
			bool from = mine.count(k->vertex), to = mine.count(k->next->vertex);
			if (from && !to) runs++;
			if (from && to && k->twin->face != f) return std::nullopt;
			if (!from) { others++; other = k->vertex; }
		}
		if (runs != 1) return std::nullopt;
		if (others == 1) ears[other]++;
	}
	for (auto k : leaving) edges_to[k->twin->vertex]++;
	for (auto& [v, n] : edges_to)
		if (n > 1 + ears[v] || v->degree() < 2 + ears[v]) return std::nullopt;

	VertexRef m = emplace_vertex();
	Vec3 sum;
	for (auto s : sides) sum += s->vertex->position;
	m->position = sum * (1.0f / sides.size());
	for (auto k : leaving) { k->vertex = m; m->halfedge = k; }
	std::set<FaceRef> beside;
	for (auto s : sides) {
		HalfedgeRef t = s->twin, p = t->prev();
		p->next = t->next;
		t->face->halfedge = t->next;
		beside.insert(t->face);
	}
	for (auto s : sides) {
		HalfedgeRef t = s->twin;
		erase_edge(s->edge); erase_halfedge(s); erase_halfedge(t);
	}
	for (auto v : mine) erase_vertex(v);
	erase_face(f);
	for (auto g : beside) if (g->sides().size() == 2) close_two_gon(g->halfedge);
	return m;
}

optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::bevel_vertex(VertexRef v) {
	auto spokes = v->spokes();
	if (spokes.size() < 3) return std::nullopt;
	FaceRef f = cut_round(spokes);
	erase_vertex(v);
	return f;
}

optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::bevel_edge(EdgeRef e) {
	HalfedgeRef h = e->halfedge, t = h->twin;
	if (h->outside() || t->outside()) return std::nullopt;
	VertexRef a = h->vertex, b = t->vertex;
	if (a->degree() < 3 || b->degree() < 3) return std::nullopt;
	vector<HalfedgeRef> spokes;
	for (auto k = t->next; k != h; k = k->twin->next) spokes.push_back(k);
	for (auto k = h->next; k != t; k = k->twin->next) spokes.push_back(k);
	FaceRef f = cut_round(spokes);
	erase_edge(e); erase_halfedge(h); erase_halfedge(t);
	erase_vertex(a); erase_vertex(b);
	return f;
}

optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::make_boundary(FaceRef f) {
	if (f->boundary) return std::nullopt;
	auto sides = f->sides();
	bool all = true;
	for (auto s : sides) {
		all = all && s->twin->outside();
		if (s->vertex->on_boundary() && !s->twin->outside() && !s->prev()->twin->outside()) return std::nullopt;
	}
	if (all) return std::nullopt;
	f->boundary = true;
	std::set<FaceRef> olds;
	vector<HalfedgeRef> stay;
	vector<std::pair<HalfedgeRef, HalfedgeRef>> go;
	for (auto s : sides) {
		if (s->twin->outside() && s->twin->face != f) { olds.insert(s->twin->face); go.push_back({s, s->twin}); }
		else stay.push_back(s);
	}
	for (auto& [s, t] : go) {
		HalfedgeRef p = s->prev(), q = t->prev();
		if (p == t) erase_vertex(s->vertex);
		else { p->next = t->next; s->vertex->halfedge = t->next; }
		if (q == s) erase_vertex(t->vertex);
		else { q->next = s->next; t->vertex->halfedge = s->next; }
		erase_edge(s->edge); erase_halfedge(s); erase_halfedge(t);
	}
	for (auto g : olds) erase_face(g);
	std::set<Index> done;
	bool first = true;
	for (auto s : stay) {
		if (done.count(s->id)) continue;
		FaceRef g = first ? f : emplace_face(true);
		first = false;
		g->halfedge = s;
		for (auto k : g->sides()) { k->face = g; done.insert(k->id); }
	}
	return f;
}

optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::weld_edges(EdgeRef e, EdgeRef e2) {
	if (e == e2 || !e->on_boundary() || !e2->on_boundary()) return std::nullopt;
	HalfedgeRef h = e->halfedge->outside() ? e->halfedge : e->halfedge->twin;
	HalfedgeRef g = e2->halfedge->outside() ? e2->halfedge : e2->halfedge->twin;
	HalfedgeRef hi = h->twin, gi = g->twin;
	// the start of h meets the end of g, and the other way round
	vector<std::pair<VertexRef, VertexRef>> meet{{h->vertex, gi->vertex}, {hi->vertex, g->vertex}};
	for (auto& [a, b] : meet) {
		if (a == b) continue;
		std::set<VertexRef> seen;
		for (auto s : a->spokes()) {
			if (s->edge != e) seen.insert(s->twin->vertex);
			if (s->twin->vertex == b) return std::nullopt;
			if (s->outside()) continue;
			for (auto k : s->face->sides()) if (k->vertex == b) return std::nullopt;
		}
		for (auto s : b->spokes()) if (s->edge != e2 && seen.count(s->twin->vertex)) return std::nullopt;
	}
	for (auto& [a, b] : meet) {
		if (a == b) continue;
		a->position = (a->position + b->position) / 2.0f;
		for (auto s : b->spokes()) s->vertex = a;
	}
	HalfedgeRef hp = h->prev(), gp = g->prev(), hn = h->next, gn = g->next;
	FaceRef fh = h->face, fg = g->face;
	vector<HalfedgeRef> rest;
	if (hn != g) { gp->next = hn; rest.push_back(hn); }
	if (gn != h) { hp->next = gn; rest.push_back(gn); }
	for (auto r : rest) {
		if (r->face != fh && r->face != fg) continue;  // named already
		FaceRef f = emplace_face(true);
		f->halfedge = r;
		for (auto k : f->sides()) k->face = f;
	}
	pair_up(hi, gi, e);
	hi->vertex->halfedge = hi;
	gi->vertex->halfedge = gi;
	for (auto& [a, b] : meet) if (a != b) erase_vertex(b);
	erase_halfedge(h); erase_halfedge(g); erase_edge(e2);
	erase_face(fh);
	if (fg != fh) erase_face(fg);
	return e;
}

void Halfedge_Mesh::extrude_positions(FaceRef face, Vec3 move, float shrink) {
	if (face->boundary) return;
	auto sides = face->sides();
	vector<Vec3> outer;
	Vec3 mean;
	for (auto s : sides) {
		// the corner below: across the side, and back down
		outer.push_back(s->twin->next->twin->vertex->position);
		mean += outer.back() / float(sides.size());
	}
	for (size_t i = 0; i < sides.size(); i++) sides[i]->vertex->position = lerp(outer[i], mean, shrink) + move;
}

void Halfedge_Mesh::bevel_positions(FaceRef face, std::vector<Vec3> const &starts, Vec3 direction, float distance) {
	size_t i = 0;
	for (auto s : face->sides()) {
		HalfedgeRef out = s->twin->next;
		Vec3 u = (out->twin->vertex->position - starts[i]).unit();
		s->vertex->position = starts[i] + distance / dot(direction, u) * u;
		i++;
	}
}
