#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE face_remove: take a face away; the outside takes its place.
//
//      o --- o --- o --- o        o --- o --- o --- o
//      |     |     |     |        |     |     |     |
//      o --- o --- o --- o        o --- o --- o --- o
//      |     |  f  |     |        |     |     |     |       the boundary at the bottom now
//      o --- o --- o --- o        o --- o     o --- o       runs around where f was
//
// Inside of the surface, the sides of f become a boundary loop of their own. A side that lay on
// a boundary has no face then, and goes; so does a corner between two such sides. The loop
// there grows into where f was. If f touched boundaries in several sides, loops may join or
// fall apart.
//
// Look first, and return std::nullopt without a change, if no surface would be left:
//   - the face touches a boundary in a corner, and in no side there;
//   - all of its sides lie on a boundary.
std::optional<FaceIter> PolyMesh::removeFace(FaceIter f) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::removeFace");
}

}  // namespace meshedit
