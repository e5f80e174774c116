#pragma once

#include <string>
#include <vector>

#include "grader/submission/submission.h"

namespace meshgrade {

/// A member of a mesh or Bezier class that is used or defined, and that the grader's class of
/// that name does not have.
struct MemberUse {
  std::string class_name;
  std::string name;
  std::string place;  ///< "student_code.cpp:160"

  bool empty() const { return class_name.empty(); }
};

/// The member that this complaint of the compiler (GCC or Clang) is about; empty if it is about
/// something else.
MemberUse unknown_member(const std::string& complaint);

/// All that these messages complain about, each once, with the place of its first use.
std::vector<MemberUse> unknown_members(const std::string& messages);

/// The first complaint about these lines of a file, without its place; empty if there is none.
std::string complaint_about(const std::string& messages, const std::string& file, int line,
                            int last_line);

/// Where a header declares a member: "halfEdgeMesh.h, line 88"; empty if none does.
std::string place_of_member(const std::vector<SourceFile>& headers, const std::string& name);

}  // namespace meshgrade
