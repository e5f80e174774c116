#pragma once

#include <string>
#include <vector>

namespace meshgrade {

/// What the compiler warns of in a file that it compiles all the same.
struct CompilerWarning {
  std::string file;  ///< as in the message: without folder if it is the student's
  int line = 0;
  std::string text;    ///< "control reaches end of non-void function"
  std::string option;  ///< "-Wreturn-type"; empty if none is named

  template <class Wire>
  void transfer(Wire& wire) {
    wire(file, line, text, option);
  }
};

/// The warnings among messages of GCC or Clang, in their order.
std::vector<CompilerWarning> warnings_in(const std::string& messages);

/// Messages without the warnings and what belongs to them, so that the first error comes first.
/// Messages without any error stay as they are.
std::string without_warnings(const std::string& messages);

}  // namespace meshgrade
