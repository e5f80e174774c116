
#include "halfedge.h"

#include <unordered_map>
#include <unordered_set>
#include <functional>
#include <set>
#include <map>

/******************************************************************
*********************** Local Operations **************************
******************************************************************/

// Everything in one function each, as drawn on paper.

std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(EdgeRef e) {
    (void)e;
    if (e->halfedge->face->boundary || e->halfedge->twin->face->boundary) {
        return std::nullopt;
    }
    HalfedgeRef h = e->halfedge;
    HalfedgeRef t = h->twin;
    HalfedgeRef h1 = h->next, h2 = h1->next;
    HalfedgeRef t1 = t->next, t2 = t1->next;
    HalfedgeRef hl = h, tl = t;
    while (hl->next != h) hl = hl->next;
    while (tl->next != t) tl = tl->next;
    VertexRef a = h->vertex, b = t->vertex, c = h2->vertex, d = t2->vertex;
    FaceRef f = h->face, g = t->face;
    // a face must not come to a corner twice
    for (HalfedgeRef k = h2; k != h; k = k->next) {
        if (k->vertex == d) return {};
    }
    for (HalfedgeRef k = t2; k != t; k = k->next) {
        if (k->vertex == c) return {};
    }
    h->set_tnvef(t, h2, d, e, f);
    t->set_tnvef(h, t2, c, e, g);
    hl->next = t1;
    t1->next = h;
    t1->face = f;
    tl->next = h1;
    h1->next = t;
    h1->face = g;
    a->halfedge = t1;
    b->halfedge = h1;
    f->halfedge = h;
    g->halfedge = t;
    return e;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::split_edge(EdgeRef e) {
    HalfedgeRef h = e->halfedge;
    if (h->face->boundary) h = h->twin; // h is inside
    HalfedgeRef t = h->twin;
    VertexRef a = h->vertex, b = t->vertex;

    VertexRef m = emplace_vertex();
    m->position = (a->position + b->position) * 0.5f;

    // the half from m to b
    EdgeRef e1 = emplace_edge();
    HalfedgeRef n = emplace_halfedge(); // m -> b
    HalfedgeRef w = emplace_halfedge(); // b -> m
    FaceRef f = h->face, g = t->face;
    HalfedgeRef tl = t;
    while (tl->next != t) tl = tl->next;
    n->set_tnvef(w, h->next, m, e1, f);
    w->set_tnvef(n, t, b, e1, g);
    e1->halfedge = n;
    tl->next = w;
    h->next = n;
    t->vertex = m;
    b->halfedge = w;
    m->halfedge = t;
    e->halfedge = h;
    if (g->halfedge == t) g->halfedge = t;

    // inside: m to the corner behind b
    {
        EdgeRef cut = emplace_edge();
        HalfedgeRef x = emplace_halfedge(); // c -> m
        HalfedgeRef y = emplace_halfedge(); // m -> c
        FaceRef k = emplace_face();
        HalfedgeRef bc = n->next;
        y->set_tnvef(x, bc->next, m, cut, f);
        x->set_tnvef(y, n, bc->next->vertex, cut, k);
        cut->halfedge = x;
        bc->next = x;
        bc->face = k;
        n->face = k;
        k->halfedge = n;
        h->next = y;
        f->halfedge = h;
    }
    if (!g->boundary) {
        EdgeRef cut = emplace_edge();
        HalfedgeRef x = emplace_halfedge(); // d -> m
        HalfedgeRef y = emplace_halfedge(); // m -> d
        FaceRef k = emplace_face();
        HalfedgeRef ad = t->next;
        y->set_tnvef(x, ad->next, m, cut, g);
        x->set_tnvef(y, t, ad->next->vertex, cut, k);
        cut->halfedge = x;
        ad->next = x;
        ad->face = k;
        t->face = k;
        k->halfedge = t;
        w->next = y;
        g->halfedge = w;
    }
    return m;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::collapse_edge(EdgeRef e) {
    HalfedgeRef h = e->halfedge, t = h->twin;
    VertexRef a = h->vertex, b = t->vertex;

    auto around = [](VertexRef v, std::function<void(HalfedgeRef)> each) {
        HalfedgeRef k = v->halfedge;
        do {
            HalfedgeRef next = k->twin->next;
            each(k);
            k = next;
        } while (k != v->halfedge);
    };

    bool bound_a = false, bound_b = false;
    around(a, [&](HalfedgeRef k) { bound_a |= k->face->boundary; });
    around(b, [&](HalfedgeRef k) { bound_b |= k->face->boundary; });
    if (bound_a && bound_b && !h->face->boundary && !t->face->boundary) return std::nullopt;

    // triangles (also of the outside) that would be left with two sides
    std::set<VertexRef> apex;
    for (HalfedgeRef s : {h, t}) {
        if (s->next->next->next != s) continue;
        if (s->face->boundary) return std::nullopt;
        VertexRef v = s->next->next->vertex;
        int n = 0;
        around(v, [&](HalfedgeRef) { n++; });
        if (n <= 2) return std::nullopt;
        apex.insert(v);
    }

    // what both ends see must be these apexes and the faces beside e, nothing else
    std::map<FaceRef, int> seen;
    std::map<VertexRef, int> shared;
    around(a, [&](HalfedgeRef k) { seen[k->face] = 1; shared[k->twin->vertex] = 1; });
    bool bad = false;
    around(b, [&](HalfedgeRef k) {
        if (seen.count(k->face) && k->face != h->face && k->face != t->face && !k->face->boundary) bad = true;
        if (shared.count(k->twin->vertex) && !apex.count(k->twin->vertex)) bad = true;
    });
    if (bad) return std::nullopt;

    // b goes, a stays
    a->position = e->center();
    std::vector<HalfedgeRef> of_b;
    around(b, [&](HalfedgeRef k) { of_b.push_back(k); });
    for (auto k : of_b) k->vertex = a;

    std::vector<HalfedgeRef> sides = {h, t};
    for (auto s : sides) {
        HalfedgeRef l = s;
        while (l->next != s) l = l->next;
        FaceRef f = s->face;
        if (s->next->next != l || f->boundary) {
            l->next = s->next;
            f->halfedge = l;
            a->halfedge = s->next;
            continue;
        }
        // a triangle: its outer twins become neighbours, the edge of l stays
        HalfedgeRef p = s->next, pt = p->twin, lt = l->twin;
        EdgeRef stay = l->edge, go = p->edge;
        pt->twin = lt;
        lt->twin = pt;
        pt->edge = stay;
        stay->halfedge = lt;
        pt->vertex->halfedge = pt;
        a->halfedge = lt;
        erase_edge(go);
        erase_halfedge(p);
        erase_halfedge(l);
        erase_face(f);
    }
    erase_halfedge(h);
    erase_halfedge(t);
    erase_edge(e);
    erase_vertex(b);
    return a;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::dissolve_edge(EdgeRef e) {
    HalfedgeRef h = e->halfedge, t = h->twin;
    std::set<unsigned int> corners;
    if (t->face->boundary) { HalfedgeRef s = h; h = t; t = s; }
    FaceRef f = h->face, g = t->face;
    for (HalfedgeRef k = h->next; k != h; k = k->next) if (k != h->next) corners.insert(k->vertex->id);
    for (HalfedgeRef k = t->next->next; k != t; k = k->next) {
        if (corners.count(k->vertex->id)) return std::nullopt;
        if (f->boundary && k->vertex->on_boundary()) return std::nullopt;
    }
    if (h->vertex->degree() <= 2 || t->vertex->degree() <= 2) return std::nullopt;

    HalfedgeRef hl = h, tl = t;
    while (hl->next != h) hl = hl->next;
    while (tl->next != t) { tl = tl->next; tl->face = f; }
    hl->next = t->next;
    tl->next = h->next;
    h->vertex->halfedge = t->next;
    t->vertex->halfedge = h->next;
    f->halfedge = hl;
    erase_halfedge(h); erase_halfedge(t); erase_edge(e); erase_face(g);
    return f;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::dissolve_vertex(VertexRef v) {
    // first look
    HalfedgeRef outside = v->halfedge;
    bool open = false;
    HalfedgeRef k = v->halfedge;
    do {
        if (k->face->boundary) { open = true; outside = k; }
        k = k->twin->next;
    } while (k != v->halfedge);

    std::set<VertexRef> ring;
    size_t steps = 0;
    k = v->halfedge;
    do {
        if (!k->face->boundary) {
            HalfedgeRef r = k->next;
            while (r->next->vertex != v) {
                ring.insert(r->vertex);
                steps++;
                r = r->next;
            }
        }
        k = k->twin->next;
    } while (k != v->halfedge);
    if (open) {
        ring.insert(outside->twin->vertex);
        steps++;
    }
    if (ring.size() != steps || steps < 3) return std::nullopt;
    if (open) {
        // a corner of a single face is refused, and so is the last vertex of a small boundary
        if (v->degree() == 2) return std::nullopt;
        if (outside->next->next->next == outside) return std::nullopt;
    }

    // then do
    if (open) {
        // v gets cut off by a new edge, as if it were in a triangle
        HalfedgeRef in = outside;
        while (in->next != outside) in = in->next;
        HalfedgeRef inl = in;
        while (inl->next != in) inl = inl->next;
        VertexRef p = in->vertex, q = outside->twin->vertex;
        EdgeRef ne = emplace_edge();
        HalfedgeRef far = emplace_halfedge(), near = emplace_halfedge();
        FaceRef tri = emplace_face();
        far->set_tnvef(near, outside->next, p, ne, outside->face);
        near->set_tnvef(far, in, q, ne, tri);
        ne->halfedge = far;
        outside->face->halfedge = far;
        inl->next = far;
        in->face = tri;
        outside->face = tri;
        outside->next = near;
        tri->halfedge = near;
    }
    // now all faces at v are inside
    std::vector<HalfedgeRef> out, rim;
    k = v->halfedge;
    do {
        out.push_back(k);
        k = k->twin->next;
    } while (k != v->halfedge);
    FaceRef keep = out[0]->face;
    for (auto o : out) {
        HalfedgeRef r = o->next, l = o;
        while (r->next->vertex != v) {
            r->face = keep;
            l = r;
            r = r->next;
        }
        // r leads to v: r->twin is the next spoke; l is the last one of the rim here
        if (l != o) rim.push_back(o);
        if (l != o) {
            l->next = r->twin->next;
            l->next->vertex->halfedge = l->next;
        }
    }
    HalfedgeRef any = out[0]->next;
    // a triangle with the new edge has the edge itself on the rim
    for (auto o : out) {
        if (o->face != keep) erase_face(o->face);
    }
    for (auto o : out) {
        HalfedgeRef back = o->twin;
        erase_edge(o->edge);
        erase_halfedge(o);
        erase_halfedge(back);
    }
    keep->halfedge = any;
    erase_vertex(v);
    return keep;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::inset_vertex(FaceRef f) {
    if (f->boundary) return std::nullopt;
    VertexRef m = emplace_vertex();
    m->position = f->center();
    std::vector<HalfedgeRef> hs;
    HalfedgeRef k = f->halfedge;
    do { hs.push_back(k); k = k->next; } while (k != f->halfedge);
    // the old face goes first, so that the first new one gets its place
    erase_face(f);
    std::vector<EdgeRef> es;
    std::vector<HalfedgeRef> ins, outs;
    std::vector<FaceRef> fs;
    for (size_t i = 0; i < hs.size(); i++) {
        es.push_back(emplace_edge());
        ins.push_back(emplace_halfedge());
        outs.push_back(emplace_halfedge());
        fs.push_back(emplace_face());
    }
    for (size_t i = 0; i < hs.size(); i++) {
        size_t j = (i + 1) % hs.size();
        // hs[i] from corner i to corner j; ins[i] from corner i to m; outs[i] back
        ins[i]->set_tnvef(outs[i], outs[(i + hs.size() - 1) % hs.size()], hs[i]->vertex, es[i], fs[(i + hs.size() - 1) % hs.size()]);
        outs[i]->set_tnvef(ins[i], hs[i], m, es[i], fs[i]);
        es[i]->halfedge = ins[i];
        fs[i]->halfedge = hs[i];
        hs[i]->next = ins[j];
        hs[i]->face = fs[i];
    }
    m->halfedge = outs.front();
    return m;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::extrude_face(FaceRef f) {
    if (f->boundary) return f;
    HalfedgeRef start = f->halfedge;
    std::vector<HalfedgeRef> low;
    HalfedgeRef k = start;
    do { low.push_back(k); k = k->next; } while (k != start);
    int n = int(low.size());
    FaceRef top = emplace_face();
    std::vector<VertexRef> v(n, vertices.end());
    std::vector<EdgeRef> rise(n), rim(n);
    std::vector<HalfedgeRef> up(n), down(n), inner(n), outer(n);
    std::vector<FaceRef> quad(n);
    for (int i = 0; i < n; i++) {
        v[i] = emplace_vertex();
        v[i]->position = low[i]->vertex->position;
        rise[i] = emplace_edge(); rim[i] = emplace_edge();
        up[i] = emplace_halfedge(); down[i] = emplace_halfedge();
        inner[i] = emplace_halfedge(); outer[i] = emplace_halfedge();
        quad[i] = emplace_face();
    }
    for (int i = 0; i < n; i++) {
        int j = (i + 1) % n, l = (i - 1 + n) % n;
        up[i]->set_tnvef(down[i], outer[l], low[i]->vertex, rise[i], quad[l]);
        down[i]->set_tnvef(up[i], low[i], v[i], rise[i], quad[i]);
        inner[i]->set_tnvef(outer[i], inner[j], v[i], rim[i], top);
        outer[i]->set_tnvef(inner[i], down[i], v[j], rim[i], quad[i]);
        low[i]->next = up[j];
        low[i]->face = quad[i];
        rise[i]->halfedge = up[i];
        rim[i]->halfedge = outer[i];
        quad[i]->halfedge = low[i];
        v[i]->halfedge = inner[i];
    }
    top->halfedge = inner[0];
    erase_face(f);
    return top;
}

void Halfedge_Mesh::extrude_positions(FaceRef face, Vec3 move, float shrink) {
    (void)face; (void)move; (void)shrink;
}
