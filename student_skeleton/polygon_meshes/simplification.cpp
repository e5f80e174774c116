#include <map>
#include <set>

#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE simplification: fewer triangles, where they are missed least.
//
//        . --- . --- .            . --- . --- .
//       / \   / \   / \          / \    |    / \         the edge a-b became the vertex v:
//      . --- a --- b --- .      .  ---  v  ---  .        two triangles less
//       \   / \   / \   /        \ /    |    \ /
//        . --- . --- .            . --- . --- .
//
// Collapse the edge of the least cost, again and again, until at most ratio times as many faces
// are left as there were. collapseEdge() is yours, from the exercise before; it puts the vertex
// in the middle, and you move it to the best point.
//
//   - A face has the quadric K of its plane: v^T K v is the squared distance of v from it.
//   - A vertex has the sum of those of its faces, an edge the sum of those of its two ends.
//   - The best point of an edge is where its quadric is least, and its cost the value there.
//   - The vertex that is left gets the quadric of the edge. The edges at it cost something else
//     then. Which edges go is known only before the collapse.
//   - An edge that collapseEdge() refuses is passed over, and is tried again when an end moves.
//
// Returns false if no collapse is left before the goal is reached.
bool PolyMesh::simplify(double ratio) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::simplify");
}

}  // namespace meshedit
