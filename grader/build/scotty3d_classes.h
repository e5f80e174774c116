#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "grader/build/member_splice.h"
#include "grader/submission/class_members.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// The classes of geometry/halfedge.h in include/dropin_scotty3d and
/// include/dropin_scotty3d_2020 that a homework can add to, and the file of each that these
/// headers include.
const std::map<std::string, std::string>& scotty3d_open_classes();

/// Whether the grader's class of these years has this member as well, or it is of the course's
/// own program and of no use to students.
bool is_in_our_scotty3d_class(const ClassMember& member, Dialect dialect);

/// "Halfedge_Mesh::Vertex::degree" is Vertex::degree.
std::string without_scotty3d_mesh(const std::string& name);

/// The members that these sources define and that neither the grader's classes have nor
/// `declared` names, each as a declaration: its head without the class.
std::vector<AddedPiece> scotty3d_members_defined(
    const std::vector<SourceFile>& sources, Dialect dialect,
    const std::set<std::pair<std::string, std::string>>& declared);

/// Whether the course's own skeleton has a member of Halfedge_Mesh by this name in the files
/// that students hand in.
bool is_provided_by_scotty3d(const std::string& name);

/// The files that halfedge.h includes where SCOTTY3D_ADDED is defined.
std::vector<SourceFile> scotty3d_added_files(const std::map<std::string, std::string>& by_class,
                                             const std::string& later);

}  // namespace meshgrade
