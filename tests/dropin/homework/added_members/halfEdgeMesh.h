// The course's header, with members of the student's own.
#ifndef HALFEDGEMESH_H
#define HALFEDGEMESH_H

namespace CGL {
  class Vertex {
  public:
    Vector3D position;
    Vector3D newPosition;
    // added:
    int timesSplit = 0;
  };

  class HalfedgeMesh {
  public:
    EdgeIter flipEdge( EdgeIter e );
    // added:
    bool canFlip( EdgeIter e );
  };
}

#endif
