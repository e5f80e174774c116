#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE vertex_bevel: put a face in the place of a vertex.
//
//            c                            c
//            |                            |
//            |                            o
//            |                           / `.
//            v                          /  f `.
//          /   `.                      o ----- o
//        /       `.                  /           `.
//      a            b              a                b
//
// Each edge at v gets an end of its own, AT THE PLACE OF v: how far it moves is for later.
// These are the corners of the new face, and its sides lie between the faces that were around
// v. On a boundary, the last side lies on the boundary. v itself goes; it may also become a
// corner.
//
// Look first, and return std::nullopt without a change, if v has two edges only.
std::optional<FaceIter> PolyMesh::bevelVertex(VertexIter v) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::bevelVertex");
}

}  // namespace meshedit
