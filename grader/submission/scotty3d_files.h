#pragma once

#include <optional>
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

/// All of those years, in the order of functions.inc in include/dropin_scotty3d or
/// include/dropin_scotty3d_2020. None for other skeletons.
const std::vector<Scotty3dFunction>& scotty3d_functions(Dialect dialect);

/// Their names in the course.
const std::set<std::string>& scotty3d_graded_functions(Dialect dialect);

/// Whether a file has the name of one that students of Scotty3D hand in: halfedge-local.cpp or
/// halfedge-global.cpp; meshedit.cpp until Spring 2022; meshEdit.cpp until 2019.
bool is_scotty3d_homework_name(const std::string& name);

/// The years of Scotty3D that these files are homework for; nothing if for none that are
/// graded. A source defines a member of Halfedge_Mesh that is graded, or has the name of one of
/// Fall 2022 and later. Until Spring 2022 the pointers of elements are functions, and some
/// members have names of their own.
std::optional<Dialect> scotty3d_years_of(const std::vector<SourceFile>& files);

/// Whether they are homework for Scotty3D of 2015 to 2019 (namespace CMU462), which is not
/// graded.
bool is_first_scotty3d_homework(const std::vector<SourceFile>& files);

/// Whether a file of such a homework is the course's own, handed in along with the student's:
/// it has the name of a file of the folders in which students of these years work, and defines
/// no graded function.
bool is_scotty3d_course_file(const SourceFile& file, Dialect dialect);

}  // namespace meshgrade
