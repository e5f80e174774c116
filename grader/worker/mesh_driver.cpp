// All of the worker that sees the elements of a mesh, or curves and patches, in one source. The
// worker's library holds it in parts; `build` compiles this anew for a submission that adds
// members to these classes, and links it before the library.

// NOLINTBEGIN(bugprone-suspicious-include)
#include "grader/worker/compute_centroid.cpp"
#include "grader/worker/exercises/bezier_curve.cpp"
#include "grader/worker/exercises/bezier_patch.cpp"
#include "grader/worker/exercises/edge_flip.cpp"
#include "grader/worker/exercises/edge_split.cpp"
#include "grader/worker/exercises/loop_subdivision.cpp"
#include "grader/worker/exercises/vertex_normal.cpp"
#include "grader/worker/mesh_operations.cpp"
#include "grader/worker/view_task.cpp"
#include "meshedit/detail/halfedge_mesh.cpp"
// NOLINTEND(bugprone-suspicious-include)
