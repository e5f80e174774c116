
#include <queue>
#include <set>
#include <unordered_map>

#include "../geometry/halfedge.h"
#include "debug.h"

// Closed meshes only; where a boundary comes near we say no.

using HRef = Halfedge_Mesh::HalfedgeRef;

static std::vector<HRef> spokes_of(Halfedge_Mesh::VertexRef v) {
    std::vector<HRef> all;
    HRef h = v->halfedge();
    do {
        all.push_back(h);
        h = h->twin()->next();
    } while(h != v->halfedge());
    return all;
}

static std::vector<HRef> sides_of(Halfedge_Mesh::FaceRef f) {
    std::vector<HRef> all;
    auto h = f->halfedge();
    do {
        all.push_back(h);
        h = h->next();
    } while(h != f->halfedge());
    return all;
}

static HRef before(HRef h) {
    HRef p = h;
    while(p->next() != h) p = p->next();
    return p;
}

// Puts a face in the place of whatever the ring of outgoing halfedges starts from.
static Halfedge_Mesh::FaceRef cut_off(Halfedge_Mesh& mesh, std::vector<HRef> ring) {
    size_t n = ring.size();
    auto f = mesh.new_face();
    std::vector<Halfedge_Mesh::VertexRef> m;
    std::vector<HRef> outer, inner;
    std::vector<Halfedge_Mesh::EdgeRef> edge;
    for(size_t i = 0; i < n; i++) {
        m.push_back(mesh.new_vertex());
        m[i]->pos = ring[i]->vertex()->pos;
        outer.push_back(mesh.new_halfedge());
        inner.push_back(mesh.new_halfedge());
        edge.push_back(mesh.new_edge());
    }
    for(size_t i = 0; i < n; i++) {
        size_t j = (i + 1) % n, l = (i + n - 1) % n;
        outer[i]->set_neighbors(ring[j], inner[i], m[i], edge[i], ring[j]->face());
        inner[i]->set_neighbors(inner[l], outer[i], m[j], edge[i], f);
        ring[i]->twin()->next() = outer[i];
        ring[i]->vertex() = m[i];
        edge[i]->halfedge() = inner[i];
        m[i]->halfedge() = ring[i];
        outer[i]->face()->halfedge() = outer[i];
    }
    f->halfedge() = inner[0];
    return f;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::erase_vertex(Halfedge_Mesh::VertexRef v) {
    if(v->on_boundary()) return std::nullopt;
    auto spokes = spokes_of(v);
    std::set<unsigned int> corners;
    size_t steps = 0;
    for(auto s : spokes) {
        for(HRef k = s->next(); k->next()->next() != s->next(); k = k->next()) {
            corners.insert(k->vertex()->id());
            steps++;
        }
    }
    // no corner may come twice
    if(steps != corners.size() || steps < 3) return std::nullopt;

    FaceRef keep = spokes[0]->face();
    for(auto s : spokes) {
        HRef k = s->next();
        while(true) {
            k->face() = keep;
            k->vertex()->halfedge() = k;
            if(k->next()->next() == s) break;
            k = k->next();
        }
        keep->halfedge() = k;
        k->next() = k->next()->twin()->next();
    }
    for(auto s : spokes) {
        if(s->face() != keep) erase(s->face());
        erase(s->edge());
        erase(s->twin());
        erase(s);
    }
    erase(v);
    return keep;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::erase_edge(Halfedge_Mesh::EdgeRef e) {
    if(e->on_boundary()) return std::nullopt;
    HalfedgeRef h = e->halfedge(), t = h->twin();
    FaceRef f = h->face(), g = t->face();
    std::set<VertexRef> corners;
    for(auto k : sides_of(f)) corners.insert(k->vertex());
    corners.erase(h->vertex());
    corners.erase(t->vertex());
    for(auto k : sides_of(g)) if(corners.count(k->vertex())) return std::nullopt;
    // an end without a third edge
    if(h->next()->twin()->next() == t || t->next()->twin()->next() == h) return std::nullopt;

    HalfedgeRef hl = before(h), tl = before(t);
    for(auto k : sides_of(g)) k->face() = f;
    hl->next() = t->next();
    tl->next() = h->next();
    h->vertex()->halfedge() = t->next();
    t->vertex()->halfedge() = h->next();
    f->halfedge() = hl;
    erase(h);
    erase(t);
    erase(e);
    erase(g);
    return f;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::collapse_edge(Halfedge_Mesh::EdgeRef e) {
    HalfedgeRef h = e->halfedge(), t = h->twin();
    VertexRef a = h->vertex(), b = t->vertex();
    if(a->on_boundary() || b->on_boundary()) return std::nullopt;

    std::set<unsigned int> tips;
    for(auto s : {h, t}) {
        if(s->face()->degree() != 3) continue;
        VertexRef tip = s->next()->next()->vertex();
        if(spokes_of(tip).size() < 3) return std::nullopt;
        tips.insert(tip->id());
    }
    std::set<unsigned int> near_a, faces_a;
    for(auto s : spokes_of(a)) {
        near_a.insert(s->twin()->vertex()->id());
        faces_a.insert(s->face()->id());
    }
    for(auto s : spokes_of(b)) {
        unsigned int v = s->twin()->vertex()->id();
        if(near_a.count(v) && !tips.count(v)) return std::nullopt;
        if(s->face() != h->face() && s->face() != t->face() && faces_a.count(s->face()->id()))
            return std::nullopt;
    }

    a->pos = e->center();
    for(auto s : spokes_of(b)) s->vertex() = a;
    for(auto s : {h, t}) {
        FaceRef f = s->face();
        if(s->next()->next()->next() != s) {
            HalfedgeRef p = before(s);
            p->next() = s->next();
            f->halfedge() = p;
            a->halfedge() = s->next();
            continue;
        }
        HalfedgeRef x = s->next(), y = x->next();
        HalfedgeRef xt = x->twin(), yt = y->twin();
        xt->twin() = yt;
        yt->twin() = xt;
        xt->edge() = y->edge();
        y->edge()->halfedge() = xt;
        xt->vertex()->halfedge() = xt;
        a->halfedge() = yt;
        erase(x->edge());
        erase(x);
        erase(y);
        erase(f);
    }
    erase(h);
    erase(t);
    erase(e);
    erase(b);
    return a;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::collapse_face(Halfedge_Mesh::FaceRef f) {
    auto sides = sides_of(f);
    std::set<VertexRef> corners;
    for(auto s : sides) {
        if(s->vertex()->on_boundary()) return std::nullopt;
        corners.insert(s->vertex());
    }
    // which faces touch f, how often, and along how many sides
    std::set<FaceRef> around;
    std::map<FaceRef, unsigned int> shared;
    for(auto s : sides) {
        shared[s->twin()->face()]++;
        for(auto k : spokes_of(s->vertex())) around.insert(k->face());
    }
    around.erase(f);
    std::vector<FaceRef> gone;
    std::map<VertexRef, unsigned int> lost;
    for(auto g : around) {
        unsigned int touched = 0;
        VertexRef other;
        for(auto k : sides_of(g)) {
            if(corners.count(k->vertex())) touched++;
            else other = k->vertex();
        }
        if(touched != shared[g] + 1) return std::nullopt;
        if(g->degree() - shared[g] < 3) {
            if(g->degree() - shared[g] < 2) return std::nullopt;
            gone.push_back(g);
            lost[other]++;
        }
    }
    for(auto& [v, n] : lost) if(spokes_of(v).size() < n + 2) return std::nullopt;
    if(gone.size() == around.size()) return std::nullopt;

    VertexRef m = new_vertex();
    m->pos = f->center();
    for(auto s : sides) for(auto k : spokes_of(s->vertex())) k->vertex() = m;
    // the sides go out of the faces beside them
    for(auto s : sides) {
        HalfedgeRef t = s->twin();
        HalfedgeRef p = before(t);
        p->next() = t->next();
        t->face()->halfedge() = p;
    }
    for(auto g : gone) {
        HalfedgeRef x = g->halfedge(), y = x->next();
        HalfedgeRef xt = x->twin(), yt = y->twin();
        xt->twin() = yt;
        yt->twin() = xt;
        erase(x->edge());
        xt->edge() = y->edge();
        yt->edge() = y->edge();
        y->edge()->halfedge() = xt;
        xt->vertex()->halfedge() = xt;
        yt->vertex()->halfedge() = yt;
        erase(x);
        erase(y);
        erase(g);
    }
    for(auto g : around) {
        if(std::find(gone.begin(), gone.end(), g) != gone.end()) continue;
        for(auto k : sides_of(g)) if(k->vertex() == m) m->halfedge() = k;
    }
    for(auto s : sides) {
        erase(s->edge());
        erase(s->twin());
        erase(s);
    }
    for(auto v : corners) erase(v);
    erase(f);
    return m;
}

std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(Halfedge_Mesh::EdgeRef e) {
    if(e->on_boundary()) return std::nullopt;
    HalfedgeRef h = e->halfedge(), t = h->twin();
    HalfedgeRef h1 = h->next(), t1 = t->next();
    HalfedgeRef h2 = h1->next(), t2 = t1->next();
    HalfedgeRef hl = before(h), tl = before(t);
    VertexRef a = h->vertex(), b = t->vertex(), c = h2->vertex(), d = t2->vertex();
    FaceRef f = h->face(), g = t->face();
    for(auto k : sides_of(f)) if(k->vertex() == d) return std::nullopt;
    for(auto k : sides_of(g)) if(k->vertex() == c) return std::nullopt;

    h->set_neighbors(h2, t, d, e, f);
    t->set_neighbors(t2, h, c, e, g);
    h1->set_neighbors(t, h1->twin(), b, h1->edge(), g);
    t1->set_neighbors(h, t1->twin(), a, t1->edge(), f);
    hl->next() = t1;
    tl->next() = h1;
    a->halfedge() = t1;
    b->halfedge() = h1;
    f->halfedge() = h;
    g->halfedge() = t;
    return e;
}

std::optional<Halfedge_Mesh::VertexRef> Halfedge_Mesh::split_edge(Halfedge_Mesh::EdgeRef e) {
    HalfedgeRef h = e->halfedge();
    if(h->is_boundary()) h = h->twin();
    HalfedgeRef t = h->twin();
    if(h->face()->degree() != 3) return std::nullopt;
    if(!t->is_boundary() && t->face()->degree() != 3) return std::nullopt;
    VertexRef a = h->vertex(), b = t->vertex();
    HalfedgeRef tl = before(t);

    // h and t stay between a and m; p and q lie between m and b
    VertexRef m = new_vertex();
    m->pos = e->center();
    EdgeRef e1 = new_edge();
    HalfedgeRef p = new_halfedge(), q = new_halfedge();
    HalfedgeRef bc = h->next(), ca = bc->next();
    FaceRef f = h->face(), g = t->face();
    EdgeRef cut = new_edge();
    HalfedgeRef up = new_halfedge(), down = new_halfedge();
    FaceRef f1 = new_face();
    h->set_neighbors(up, t, a, e, f);
    up->set_neighbors(ca, down, m, cut, f);
    ca->face() = f;
    f->halfedge() = h;
    p->set_neighbors(bc, q, m, e1, f1);
    bc->set_neighbors(down, bc->twin(), b, bc->edge(), f1);
    down->set_neighbors(p, up, ca->vertex(), cut, f1);
    f1->halfedge() = p;
    cut->halfedge() = up;
    e->halfedge() = h;
    e1->halfedge() = p;
    m->halfedge() = p;
    a->halfedge() = h;
    b->halfedge() = q;
    if(g->is_boundary()) {
        q->set_neighbors(t, p, b, e1, g);
        t->set_neighbors(t->next(), h, m, e, g);
        tl->next() = q;
        return m;
    }
    HalfedgeRef ad = t->next(), db = tl;
    EdgeRef cut1 = new_edge();
    HalfedgeRef out = new_halfedge(), in = new_halfedge();
    FaceRef g1 = new_face();
    t->set_neighbors(ad, h, m, e, g1);
    ad->set_neighbors(in, ad->twin(), a, ad->edge(), g1);
    in->set_neighbors(t, out, db->vertex(), cut1, g1);
    g1->halfedge() = t;
    q->set_neighbors(out, p, b, e1, g);
    out->set_neighbors(db, in, m, cut1, g);
    db->set_neighbors(q, db->twin(), db->vertex(), db->edge(), g);
    g->halfedge() = q;
    cut1->halfedge() = in;
    return m;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::bevel_vertex(Halfedge_Mesh::VertexRef v) {
    if(v->on_boundary()) return std::nullopt;
    auto spokes = spokes_of(v);
    if(spokes.size() < 3) return std::nullopt;
    FaceRef f = cut_off(*this, spokes);
    erase(v);
    return f;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::bevel_edge(Halfedge_Mesh::EdgeRef e) {
    HalfedgeRef h = e->halfedge(), t = h->twin();
    VertexRef a = h->vertex(), b = t->vertex();
    if(a->on_boundary() || b->on_boundary()) return std::nullopt;
    std::vector<HRef> ring;
    for(HRef s = t->next(); s != h; s = s->twin()->next()) ring.push_back(s);
    for(HRef s = h->next(); s != t; s = s->twin()->next()) ring.push_back(s);
    if(ring.size() < 3) return std::nullopt;
    FaceRef f = cut_off(*this, ring);
    erase(a);
    erase(b);
    erase(h);
    erase(t);
    erase(e);
    return f;
}

std::optional<Halfedge_Mesh::FaceRef> Halfedge_Mesh::bevel_face(Halfedge_Mesh::FaceRef f) {
    auto low = sides_of(f);
    size_t n = low.size();
    std::vector<VertexRef> v;
    std::vector<EdgeRef> rise, rim;
    std::vector<HalfedgeRef> up, down, inner, outer;
    std::vector<FaceRef> quad;
    for(auto s : low) {
        v.push_back(new_vertex());
        v.back()->pos = s->vertex()->pos;
        rise.push_back(new_edge());
        rim.push_back(new_edge());
        up.push_back(new_halfedge());
        down.push_back(new_halfedge());
        inner.push_back(new_halfedge());
        outer.push_back(new_halfedge());
        quad.push_back(new_face());
    }
    for(size_t i = 0; i < n; i++) {
        size_t j = (i + 1) % n, l = (i + n - 1) % n;
        up[i]->set_neighbors(outer[l], down[i], low[i]->vertex(), rise[i], quad[l]);
        down[i]->set_neighbors(low[i], up[i], v[i], rise[i], quad[i]);
        inner[i]->set_neighbors(inner[j], outer[i], v[i], rim[i], f);
        outer[i]->set_neighbors(down[i], inner[i], v[j], rim[i], quad[i]);
        low[i]->next() = up[j];
        low[i]->face() = quad[i];
        rise[i]->halfedge() = up[i];
        rim[i]->halfedge() = inner[i];
        quad[i]->halfedge() = low[i];
        v[i]->halfedge() = inner[i];
    }
    f->halfedge() = inner[0];
    return f;
}

void Halfedge_Mesh::bevel_vertex_positions(const std::vector<Vec3>& start_positions,
                                           Halfedge_Mesh::FaceRef face, float tangent_offset) {
    std::vector<HalfedgeRef> new_halfedges;
    auto h = face->halfedge();
    do {
        new_halfedges.push_back(h);
        h = h->next();
    } while(h != face->halfedge());

    for(size_t i = 0; i < new_halfedges.size(); i++) {
        Vec3 to = new_halfedges[i]->twin()->next()->twin()->vertex()->pos;
        new_halfedges[i]->vertex()->pos = start_positions[i] + tangent_offset * (start_positions[i] - to).unit();
    }
}

void Halfedge_Mesh::bevel_edge_positions(const std::vector<Vec3>& start_positions,
                                         Halfedge_Mesh::FaceRef face, float tangent_offset) {
    bevel_vertex_positions(start_positions, face, tangent_offset);
}

void Halfedge_Mesh::bevel_face_positions(const std::vector<Vec3>& start_positions,
                                         Halfedge_Mesh::FaceRef face, float tangent_offset,
                                         float normal_offset) {
    if(flip_orientation) normal_offset = -normal_offset;
    Vec3 mean;
    for(auto& p : start_positions) mean += p / (float)start_positions.size();
    size_t i = 0;
    Vec3 n = face->normal();
    for(auto h : sides_of(face)) {
        h->vertex()->pos = start_positions[i] + tangent_offset * (start_positions[i] - mean) + normal_offset * n;
        i++;
    }
}

void Halfedge_Mesh::triangulate() {
    if(debug_data.normal_colors) info("triangulating %zu faces", n_faces());
    for(FaceRef f = faces_begin(); f != faces_end(); f++) {
        if(f->is_boundary()) continue;
        auto sides = sides_of(f);
        HalfedgeRef low = sides[0];
        for(size_t i = 1; i + 2 < sides.size(); i++) {
            // a triangle of low, sides[i] and the way back
            EdgeRef e = new_edge();
            HalfedgeRef back = new_halfedge(), on = new_halfedge();
            FaceRef t = new_face();
            back->set_neighbors(low, on, sides[i + 1]->vertex(), e, t);
            on->set_neighbors(sides[i + 1], back, sides[0]->vertex(), e, f);
            e->halfedge() = on;
            low->next() = sides[i];
            low->face() = t;
            sides[i]->next() = back;
            sides[i]->face() = t;
            t->halfedge() = back;
            sides.back()->next() = on;
            f->halfedge() = on;
            low = on;
        }
    }
}

void Halfedge_Mesh::linear_subdivide_positions() {
    for(VertexRef v = vertices_begin(); v != vertices_end(); v++) v->new_pos = v->pos;
    for(EdgeRef e = edges_begin(); e != edges_end(); e++) e->new_pos = e->center();
    for(FaceRef f = faces_begin(); f != faces_end(); f++) f->new_pos = f->center();
}

void Halfedge_Mesh::catmullclark_subdivide_positions() {
    for(FaceRef f = faces_begin(); f != faces_end(); f++) f->new_pos = f->center();
    for(EdgeRef e = edges_begin(); e != edges_end(); e++) {
        HalfedgeRef h = e->halfedge();
        e->new_pos = (h->vertex()->pos + h->twin()->vertex()->pos + h->face()->new_pos +
                      h->twin()->face()->new_pos) / 4.0f;
    }
    for(VertexRef v = vertices_begin(); v != vertices_end(); v++) {
        Vec3 Q, R;
        float n = (float)v->degree();
        for(auto s : spokes_of(v)) {
            Q += s->face()->new_pos / n;
            R += s->edge()->center() / n;
        }
        v->new_pos = (Q + 2.0f * R + (n - 3.0f) * v->pos) / n;
    }
}

void Halfedge_Mesh::loop_subdivide() {
    for(VertexRef v = vertices_begin(); v != vertices_end(); v++) {
        v->is_new = false;
        float n = (float)v->degree();
        float u = v->degree() == 3 ? 3.0f / 16.0f : 3.0f / (8.0f * n);
        v->new_pos = (1.0f - n * u) * v->pos + u * n * v->neighborhood_center();
    }
    for(EdgeRef e = edges_begin(); e != edges_end(); e++) {
        e->is_new = false;
        HalfedgeRef h = e->halfedge(), t = h->twin();
        e->new_pos = 3.0f / 8.0f * (h->vertex()->pos + t->vertex()->pos) +
                     1.0f / 8.0f * (h->next()->next()->vertex()->pos + t->next()->next()->vertex()->pos);
    }
    Size n = n_edges();
    EdgeRef e = edges_begin();
    for(Size i = 0; i < n; i++, e++) {
        Vec3 to = e->new_pos;
        VertexRef m = split_edge(e).value();
        m->is_new = true;
        m->new_pos = to;
        auto spokes = spokes_of(m);
        for(size_t k = 0; k < spokes.size(); k++) spokes[k]->edge()->is_new = k % 2 == 1;
    }
    for(EdgeRef c = edges_begin(); c != edges_end(); c++) {
        if(!c->is_new) continue;
        if(c->halfedge()->vertex()->is_new != c->halfedge()->twin()->vertex()->is_new) flip_edge(c);
    }
    for(VertexRef v = vertices_begin(); v != vertices_end(); v++) v->pos = v->new_pos;
}

bool Halfedge_Mesh::isotropic_remesh() {
    float mean = 0.0f;
    for(EdgeRef e = edges_begin(); e != edges_end(); e++) mean += e->length() / (float)n_edges();
    std::vector<EdgeRef> shorter;
    for(EdgeRef e = edges_begin(); e != edges_end(); e++) if(e->length() < 0.8f * mean) shorter.push_back(e);
    if(!shorter.empty()) collapse_edge_erase(shorter[0]);
    return !validate().has_value();
}

struct Edge_Record {
    Edge_Record() {}
    Edge_Record(std::unordered_map<Halfedge_Mesh::VertexRef, Mat4>& vertex_quadrics,
                Halfedge_Mesh::EdgeRef e)
        : edge(e) {
        Mat4 K = vertex_quadrics[e->halfedge()->vertex()] + vertex_quadrics[e->halfedge()->twin()->vertex()];
        optimal = e->center();
        cost = dot(Vec4(optimal, 1.0f), K * Vec4(optimal, 1.0f));
    }
    Halfedge_Mesh::EdgeRef edge;
    Vec3 optimal;
    float cost;
};

bool operator<(const Edge_Record& r1, const Edge_Record& r2) {
    if(r1.cost != r2.cost) {
        return r1.cost < r2.cost;
    }
    Halfedge_Mesh::EdgeRef e1 = r1.edge;
    Halfedge_Mesh::EdgeRef e2 = r2.edge;
    return &*e1 < &*e2;
}

template<class T> struct PQueue {
    void insert(const T& item) {
        queue.insert(item);
    }
    void remove(const T& item) {
        if(queue.find(item) != queue.end()) {
            queue.erase(item);
        }
    }
    const T& top(void) const {
        return *(queue.begin());
    }
    void pop(void) {
        queue.erase(queue.begin());
    }
    size_t size() {
        return queue.size();
    }

    std::set<T> queue;
};

bool Halfedge_Mesh::simplify() {
    std::unordered_map<VertexRef, Mat4> vertex_quadrics;
    std::unordered_map<FaceRef, Mat4> face_quadrics;
    std::unordered_map<EdgeRef, Edge_Record> edge_records;
    PQueue<Edge_Record> edge_queue;
    for(EdgeRef e = edges_begin(); e != edges_end(); e++) {
        edge_records[e] = Edge_Record(vertex_quadrics, e);
        edge_queue.insert(edge_records[e]);
    }
    return edge_queue.size() > 0 && eerased.empty();
}
