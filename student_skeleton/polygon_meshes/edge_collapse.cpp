#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE edge_collapse: shrink an edge to one vertex, in its middle.
//
//           c                     c                   d --- a --- y         d ------- y
//         /   \                   |                   |     |     |          \       /
//       a ----- b                 v                   |     |     |            \   /
//         \   /                   |                   |     |     |              v
//           d                     d                   x --- b --- z         x --'  `-- z
//
// A triangle beside the edge vanishes: its two other sides become one edge. A larger face only
// loses a corner. What the vanished elements anchored needs another anchor, and every half-edge
// that left b starts at the vertex that is left.
//
// Look first, and return std::nullopt without a change, if no surface would be left:
//   - both ends lie on a boundary, and the edge does not;
//   - another face than those beside the edge has both ends as corners;
//   - a triangle would vanish whose third corner has no third edge;
//   - a boundary of three edges would lose one.
std::optional<VertexIter> PolyMesh::collapseEdge(EdgeIter e) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::collapseEdge");
}

}  // namespace meshedit
