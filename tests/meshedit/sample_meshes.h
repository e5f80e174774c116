#pragma once

#include <vector>

#include "meshedit/meshedit.h"

namespace meshedit {

struct Polygons {
  std::vector<std::vector<Index>> corners;
  std::vector<Vector3D> positions;
};

HalfedgeMesh mesh_of(const Polygons& polygons);

/// One triangle: every edge is a boundary edge.
Polygons triangle();

/// Two triangles with a common edge: the picture of the exercises, with a, b, c, d = 0, 1,
/// 2, 3.
Polygons diamond();

/// Vertices (1,1,1), (1,-1,-1), (-1,1,-1), (-1,-1,1). Every vertex has 3 neighbours.
Polygons tetrahedron();

/// Vertices 1 away from the origin, in the order +x, -x, +y, -y, +z, -z. Valence 4.
Polygons octahedron();

/// [-1,1]^3 with a vertex in the middle of each side (numbers 8 to 13), as 24 triangles.
Polygons cube_with_centers();

/// [-1,1]^3 as six squares.
Polygons cube_of_squares();

/// A flat sheet of columns x rows unit squares, each cut from lower left to upper right.
/// Vertex (i, j, 0) has number j (columns + 1) + i.
Polygons sheet(Index columns, Index rows);

/// The same, with opposite sides glued to a torus (columns, rows >= 3).
Polygons torus(Index columns, Index rows);

/// A sheet of 3 x 3 squares without the one in the middle: two boundary loops.
Polygons frame();

/// `n` triangles around vertex 0; closed: a disk all around it, otherwise with a gap.
Polygons fan(Index n, bool closed);

/// Both in one mesh. The vertices of `b` follow after those of `a`.
Polygons together(const Polygons& a, const Polygons& b);

/// All of the above that have only triangles.
std::vector<Polygons> all_triangle_meshes();

}  // namespace meshedit
