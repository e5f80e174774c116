#include <set>
#include <unordered_map>
#include <vector>

#include "../geometry/halfedge.h"
#include "debug.h"

// what is here works at boundaries, too

Halfedge_Mesh::EdgeRef Halfedge_Mesh::connect(HalfedgeRef h, HalfedgeRef k) {
    FaceRef f = h->face();
    HalfedgeRef hp = h->prev(), kp = k->prev();
    EdgeRef e = new_edge();
    HalfedgeRef there = new_halfedge(), back = new_halfedge();
    FaceRef g = new_face();
    there->set_neighbors(k, back, h->vertex(), e, f);
    back->set_neighbors(h, there, k->vertex(), e, g);
    hp->_next = there;
    kp->_next = back;
    e->_halfedge = there;
    f->_halfedge = there;
    g->_halfedge = back;
    for(HalfedgeRef s = back; s->face() != g || s == back; s = s->next()) {
        s->face() = g;
        if(s->next() == back) break;
    }
    return e;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::collapse_edge(Halfedge_Mesh::EdgeRef e) {
    HalfedgeRef h = e->halfedge();
    HalfedgeRef t = h->twin();
    VertexRef a = h->vertex(), b = t->vertex();
    if(a->on_boundary() && b->on_boundary() && !e->on_boundary()) return {};

    std::set<VertexRef> apex;
    for(HalfedgeRef s : {h, t}) {
        if(s->next()->next()->next() != s) continue;
        if(s->is_boundary()) return {};
        if(s->next()->next()->vertex()->outgoing().size() <= 2) return {};
        apex.insert(s->next()->next()->vertex());
    }
    std::set<FaceRef> faces;
    std::set<VertexRef> ends;
    for(auto s : a->outgoing()) {
        if(!s->is_boundary()) faces.insert(s->face());
        ends.insert(s->twin()->vertex());
    }
    for(auto s : b->outgoing()) {
        if(s->face() != h->face() && s->face() != t->face() && faces.count(s->face())) return {};
        if(ends.count(s->twin()->vertex()) && !apex.count(s->twin()->vertex())) return {};
    }

    a->pos = e->center();
    for(auto s : b->outgoing()) s->vertex() = a;
    for(auto s : {h, t}) {
        HalfedgeRef next = s->next(), prev = s->prev();
        FaceRef f = s->face();
        prev->next() = next;
        f->halfedge() = next;
        a->halfedge() = next;
        if(next->next() != prev) continue;
        // two sides are left: their other halves become one edge
        HalfedgeRef x = next->twin(), y = prev->twin();
        erase(next->edge());
        x->twin() = y;
        y->twin() = x;
        x->edge() = y->edge();
        x->edge()->halfedge() = x;
        x->vertex()->halfedge() = x;
        y->vertex()->halfedge() = y;
        erase(next);
        erase(prev);
        erase(f);
    }
    erase(e->halfedge());
    erase(t == e->halfedge() ? h : t);
    erase(e);
    erase(b);
    return a;
}

std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(Halfedge_Mesh::EdgeRef e) {
    HalfedgeRef h = e->halfedge(), t = h->twin();
    if(h->is_boundary() || t->is_boundary()) return std::nullopt;
    VertexRef to = h->next()->next()->vertex(), from = t->next()->next()->vertex();
    for(HalfedgeRef s = h->next()->next(); s != h; s = s->next()) if(s->vertex() == from) return std::nullopt;
    for(HalfedgeRef s = t->next()->next(); s != t; s = s->next()) if(s->vertex() == to) return std::nullopt;
    HalfedgeRef hp = h->prev(), tp = t->prev(), hn = h->next(), tn = t->next();
    h->vertex()->halfedge() = tn;
    t->vertex()->halfedge() = hn;
    hp->next() = tn;
    tp->next() = hn;
    h->next() = hn->next();
    t->next() = tn->next();
    hn->next() = t;
    tn->next() = h;
    hn->face() = t->face();
    tn->face() = h->face();
    h->vertex() = from;
    t->vertex() = to;
    h->face()->halfedge() = h;
    t->face()->halfedge() = t;
    return e;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::bisect_edge(EdgeRef e) {
    HalfedgeRef h = e->halfedge(), t = h->twin();
    VertexRef m = new_vertex();
    m->pos = e->center();
    EdgeRef more = new_edge();
    HalfedgeRef on = new_halfedge(), to = new_halfedge();
    on->set_neighbors(h->next(), to, m, more, h->face());
    to->set_neighbors(t, on, t->vertex(), more, t->face());
    t->prev()->next() = to;
    h->next() = on;
    t->vertex()->halfedge() = to;
    t->vertex() = m;
    more->halfedge() = on;
    m->halfedge() = on;
    return m;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::split_edge(Halfedge_Mesh::EdgeRef e) {
    auto m = bisect_edge(e);
    for(HalfedgeRef s : (*m)->outgoing()) {
        if(s->is_boundary()) continue;
        connect(s, s->next()->next());
    }
    return m;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::inset_vertex(FaceRef f) {
    if(f->is_boundary()) return std::nullopt;
    std::vector<HalfedgeRef> sides;
    for(HalfedgeRef s = f->halfedge(); sides.empty() || s != sides[0]; s = s->next()) sides.push_back(s);
    VertexRef m = new_vertex();
    m->pos = f->center();
    HalfedgeRef first, last;
    for(size_t i = 0; i < sides.size(); i++) {
        EdgeRef e = new_edge();
        HalfedgeRef in = new_halfedge(), out = new_halfedge();
        FaceRef t = i == 0 ? f : new_face();
        e->halfedge() = in;
        // out starts the triangle of sides[i]; in ends the one before
        out->set_neighbors(sides[i], in, m, e, t);
        in->twin() = out;
        in->edge() = e;
        in->vertex() = sides[i]->vertex();
        sides[i]->face() = t;
        t->halfedge() = sides[i];
        if(i == 0) {
            first = in;
        } else {
            in->next() = last;
            in->face() = last->face();
            sides[i - 1]->next() = in;
        }
        last = out;
    }
    first->next() = last;
    first->face() = last->face();
    sides.back()->next() = first;
    m->halfedge() = last;
    return m;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::bevel_face(Halfedge_Mesh::FaceRef f) {

    (void)f;
    return std::nullopt;
}

void Halfedge_Mesh::triangulate() {
    std::vector<FaceRef> wide;
    for(auto f = faces_begin(); f != faces_end(); f++) if(!f->is_boundary()) wide.push_back(f);
    for(auto f : wide) {
        while(f->degree() > 3) {
            HalfedgeRef h = f->halfedge();
            connect(h, h->next()->next());
        }
    }
}

void Halfedge_Mesh::linear_subdivide_positions() {
    for(auto& v : vertices) v.new_pos = v.pos;
    for(auto& e : edges) e.new_pos = e.center();
    for(auto& f : faces) {
        if(f.is_boundary()) continue;
        f.new_pos = f.center();
    }
}
