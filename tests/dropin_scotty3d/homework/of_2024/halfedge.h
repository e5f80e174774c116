#pragma once
// The header as this student has it: the course's members, and a few more.

#include <list>
#include <optional>
#include <string>
#include <variant>
#include <vector>
#include <unordered_map>

#include "../lib/mathlib.h"

class Indexed_Mesh;

class Halfedge_Mesh {
public:
	class Vertex;
	class Edge;
	class Face;
	class Halfedge;
	using Index = uint32_t;
	using VertexRef = std::list<Vertex>::iterator;
	using VertexCRef = std::list<Vertex>::const_iterator;
	using EdgeRef = std::list<Edge>::iterator;
	using EdgeCRef = std::list<Edge>::const_iterator;
	using FaceRef = std::list<Face>::iterator;
	using FaceCRef = std::list<Face>::const_iterator;
	using HalfedgeRef = std::list<Halfedge>::iterator;
	using HalfedgeCRef = std::list<Halfedge>::const_iterator;

	class Vertex {
	public:
		HalfedgeRef halfedge;
		Index id;
		Vec3 position;
		bool on_boundary() const;
		uint32_t degree() const;
		// mine:
		int mark = 0;
		std::vector<HalfedgeRef> spokes();
	};
	class Edge {
	public:
		HalfedgeRef halfedge;
		Index id;
		bool sharp = false;
		Vec3 center() const;
	};
	class Face {
	public:
		HalfedgeRef halfedge;
		Index id;
		bool boundary = false;
		std::vector<HalfedgeRef> sides() {
			std::vector<HalfedgeRef> all;
			HalfedgeRef h = halfedge;
			do { all.push_back(h); h = h->next; } while (h != halfedge);
			return all;
		}
	};
	class Halfedge {
	public:
		HalfedgeRef twin, next;
		VertexRef vertex;
		EdgeRef edge;
		FaceRef face;
		Index id;
		HalfedgeRef prev();
		bool outside() const { return face->boundary; }
		void set_tnvef(HalfedgeRef, HalfedgeRef, VertexRef, EdgeRef, FaceRef);
	};

	std::list<Vertex> vertices;
	std::list<Edge> edges;
	std::list<Face> faces;
	std::list<Halfedge> halfedges;

	VertexRef emplace_vertex();
	std::optional<EdgeRef> flip_edge(EdgeRef e);
	std::optional<VertexRef> split_edge(EdgeRef e);
	std::optional<VertexRef> collapse_edge(EdgeRef e);
	std::optional<FaceRef> extrude_face(FaceRef f);
	std::optional<FaceRef> dissolve_vertex(VertexRef v);
	std::optional<FaceRef> dissolve_edge(EdgeRef e);
	std::optional<VertexRef> collapse_face(FaceRef f);
	std::optional<VertexRef> inset_vertex(FaceRef f);
	std::optional<FaceRef> bevel_vertex(VertexRef v);
	std::optional<FaceRef> bevel_edge(EdgeRef e);
	std::optional<FaceRef> make_boundary(FaceRef f);

	Indexed_Mesh to_indexed_mesh() const;
	void flip_orientation();

	// mine
	void pair_up(HalfedgeRef a, HalfedgeRef b, EdgeRef e);
	void close_two_gon(HalfedgeRef x);
	EdgeRef link(HalfedgeRef from, HalfedgeRef to, FaceRef beside);
	FaceRef cut_round(const std::vector<HalfedgeRef>& spokes);

private:
	std::list<Vertex> free_vertices;
	Index next_id = 0;
};

inline Halfedge_Mesh::HalfedgeRef last_of(Halfedge_Mesh::HalfedgeRef h) { return h->prev(); }
