#pragma once

#include <set>
#include <string>
#include <vector>

#include "grader/submission/submission.h"

namespace meshgrade {

/// A function that students of the course of Scotty3D write, and that is graded.
struct Scotty3dFunction {
  std::string exercise;    ///< "edge_collapse"
  std::string our_name;    ///< "PolyMesh::collapseEdge"
  std::string their_name;  ///< "Halfedge_Mesh::collapse_edge"
};

/// All of them, in the order of include/dropin_scotty3d/functions.inc.
const std::vector<Scotty3dFunction>& scotty3d_functions();

/// Their names in the course.
const std::set<std::string>& scotty3d_graded_functions();

/// Whether a file has the name of one that students of Scotty3D hand in (Fall 2022 and later):
/// halfedge-local.cpp or halfedge-global.cpp.
bool is_scotty3d_homework_name(const std::string& name);

/// Whether these files are homework for Scotty3D of Fall 2022 or later: a source defines a
/// member of Halfedge_Mesh that is graded, and the pointers of elements are members and not
/// functions.
bool is_scotty3d_homework(const std::vector<SourceFile>& files);

/// Whether they are homework for Scotty3D of Fall 2020 to Spring 2022, which is not graded: the
/// pointers of elements are functions there.
bool is_earlier_scotty3d_homework(const std::vector<SourceFile>& files);

/// Whether a file of such a homework is the course's own, handed in along with the student's:
/// it has the name of a file of the course's folder src/geometry and defines no graded
/// function.
bool is_scotty3d_course_file(const SourceFile& file);

}  // namespace meshgrade
