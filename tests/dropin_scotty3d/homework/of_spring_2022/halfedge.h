#pragma once

#include <list>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "../platform/gl.h"

enum class SubD { linear, catmullclark, loop };

class Halfedge_Mesh {
public:
    using Index = size_t;
    using Size = size_t;

    class Vertex;
    class Edge;
    class Face;
    class Halfedge;

    using VertexRef = std::list<Vertex>::iterator;
    using EdgeRef = std::list<Edge>::iterator;
    using FaceRef = std::list<Face>::iterator;
    using HalfedgeRef = std::list<Halfedge>::iterator;

    std::optional<EdgeRef> flip_edge(EdgeRef e);
    std::optional<VertexRef> split_edge(EdgeRef e);
    std::optional<VertexRef> inset_vertex(FaceRef f);

    // mine: a new edge from where h starts to where k starts, both in one face
    EdgeRef connect(HalfedgeRef h, HalfedgeRef k);

    class Vertex {
    public:
        HalfedgeRef& halfedge() {
            return _halfedge;
        }
        // mine
        std::vector<HalfedgeRef> outgoing() {
            std::vector<HalfedgeRef> all;
            HalfedgeRef h = _halfedge;
            do {
                all.push_back(h);
                h = h->twin()->next();
            } while(h != _halfedge);
            return all;
        }
        bool on_boundary() const;
        unsigned int id() const {
            return _id;
        }
        Vec3 pos;

    private:
        Vertex(unsigned int id) : _id(id) {
        }
        Vec3 new_pos;
        bool is_new = false;
        unsigned int _id = 0;
        HalfedgeRef _halfedge;
        friend class Halfedge_Mesh;
    };

    class Halfedge {
    public:
        HalfedgeRef& twin() {
            return _twin;
        }
        HalfedgeRef& next() {
            return _next;
        }
        HalfedgeRef prev() {
            HalfedgeRef p = _twin;
            while(&*p->next() != this) p = p->next()->twin();
            return p;
        }
        bool is_boundary() const {
            return _face->is_boundary();
        }

    private:
        Halfedge(unsigned int id) : _id(id) {
        }
        unsigned int _id = 0;
        HalfedgeRef _twin, _next;
        VertexRef _vertex;
        EdgeRef _edge;
        FaceRef _face;
        friend class Halfedge_Mesh;
    };

    void erase(VertexRef v) {
        verased.insert(v);
    }
    bool has_boundary() const;
    void clear();
    bool subdivide(SubD strategy);
    void do_erase();

private:
    std::list<Vertex> vertices;
    unsigned int next_id;
    std::set<VertexRef> verased;
};
