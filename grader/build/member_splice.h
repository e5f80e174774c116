#pragma once

#include <string>
#include <vector>

#include "grader/build/added_members.h"
#include "grader/submission/class_members.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// A piece of the course's files that the student has written.
struct AddedPiece {
  std::string file;  ///< where it stands; empty if it was told from its use
  ClassMember member;
  bool later = false;  ///< a function defined behind the classes, and not in one
};

/// The members that a homework for Berkeley's skeleton adds to the course's mesh and Bezier
/// classes, on their way into the grader's own. The data become a base of the class, the
/// functions stand in the class: the shared headers include the files that this makes. All that
/// sees these classes in one build must be compiled with the same data.
///
/// In homework for Scotty3D data and functions stand in the classes of include/dropin_scotty3d
/// or include/dropin_scotty3d_2020, which the worker does not see; and what the student's files
/// define need not be declared.
class MemberSplice {
 public:
  MemberSplice() = default;

  /// Compares the headers that were handed in with what the course's hold. What the student's
  /// own files do not use, directly or by another of these members, is left where it is.
  explicit MemberSplice(const Submission& submission);

  bool empty() const { return pieces_.empty(); }

  /// Adds data that are used and declared nowhere, if their use tells what they are: a truth
  /// value, a whole number, a number or a Vector3D; and functions that are defined and declared
  /// nowhere. A name that is nearly one of the course's is taken for a slip of the pen.
  /// @return whether there are any
  bool add_from_use(const std::vector<MemberUse>& uses, const Submission& submission);

  /// Takes out the pieces that the compiler complains about; all of them if it blames none.
  void drop_blamed(const std::string& messages);
  void drop_all(const std::string& reason);

  /// Whether one of the handed-in headers declares this member, taken over or not.
  bool is_declared(const MemberUse& member) const;

  /// Whether a name is nearly one of the course's.
  static bool is_slip(const MemberUse& use);

  /// The files that halfedge_mesh.h includes, and the last one that follows course.h.
  std::vector<SourceFile> files() const;
  static constexpr const char* kLater = "meshedit_added_later.h";

  /// What was taken over, what was told from its use, and what could not be taken over.
  std::vector<std::string> notes() const;

 private:
  bool add_defined(const MemberUse& use, const Submission& submission);
  void add_scotty3d(const Submission& submission);
  void add_header(const SourceFile& header);
  void add_definitions(const SourceFile& file);
  void keep_used(const Submission& submission);

  Dialect dialect_ = Dialect::kMeshedit;
  std::vector<AddedPiece> pieces_;
  std::vector<std::pair<std::string, std::string>> declared_;  ///< class and name
  std::vector<std::string> troubles_;
  std::vector<std::string> from_use_;
};

}  // namespace meshgrade
