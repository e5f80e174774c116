#pragma once

#include <stdexcept>
#include <string>

namespace meshgrade {

/// Something that the person at the keyboard can mend: a bad option, a file that cannot be
/// read, a broken mesh. The message is one line, names the file and the place, and says what
/// to do. Ends the program with exit code 2.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A fault of the grader itself. Never counted against a student. Ends the program with exit
/// code 3.
class GraderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace meshgrade
