#pragma once

#include <set>
#include <string>
#include <vector>

namespace meshgrade {

/// A function that does not compile.
struct LeftOut {
  std::string function;     ///< "HalfedgeMesh::flipEdge"
  int line = 0;             ///< of the first complaint about it
  std::string message;      ///< that complaint
  bool not_judged = false;  ///< it is no fault of the code: the grader lacks what it uses

  template <class Wire>
  void transfer(Wire& wire) {
    wire(function, line, message, not_judged);
  }
};

/// Takes functions that do not compile out of a source, so that the others can be graded. The
/// lines that stay keep their numbers.
class LeavingOut {
 public:
  /// @param file  the file's name in the compiler's messages
  LeavingOut(std::string file, std::string text)
      : file_(std::move(file)), text_(std::move(text)) {}

  /// What is left of the source.
  const std::string& text() const { return text_; }
  const std::vector<LeftOut>& left_out() const { return left_out_; }

  /// Takes out the functions that these messages complain about. At first only the body goes,
  /// and calling the function answers "not implemented"; a function that is complained about
  /// again goes as a whole. Functions whose braces are out of order go before all others, since
  /// then the compiler complains at the wrong place.
  /// @return false if no function is to blame
  bool learn_from(const std::string& messages);

  /// Makes those of these functions that are as Berkeley's skeleton hands them out answer "not
  /// implemented": a body without statements, or one that only returns a value that says
  /// nothing, such as `Vector3D()` or the edge that it was given.
  void mark_unwritten(const std::set<std::string>& functions);

  /// The same for the skeleton of Scotty3D: a body that does nothing but to refuse, with
  /// `return std::nullopt;` or `return false;`, or that has no statements. Those that only say
  /// that a parameter is not used, `(void)e;`, do not count.
  void mark_refusing(const std::set<std::string>& functions);

  /// Takes out all members of a class.
  void remove_members(const std::string& class_name);

  /// Takes out the definitions of a function: "HalfedgeMesh::flipEdge".
  void remove_function(const std::string& name);

 private:
  template <class DoesNothing>
  void mark(const std::set<std::string>& functions, DoesNothing does_nothing);
  template <class Chosen>
  void remove(Chosen chosen);

  std::string file_;
  std::string text_;
  std::vector<LeftOut> left_out_;
};

}  // namespace meshgrade
