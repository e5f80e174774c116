#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "grader/view/student_program.h"
#include "grader/writeup/document.h"
#include "grader/writeup/rubric.h"

namespace meshgrade {

/// Where a write-up's pictures lie, from beside its text.
constexpr const char* kWriteupPictures = "pictures";

/// How pictures are to be made.
struct WriteupSetup {
  std::filesystem::path folder;  ///< gets the pictures, in `kWriteupPictures`
  std::string page;              ///< the viewer's page, without data
  bool svg = false;              ///< by the grader alone, though there may be a browser
};

/// Makes all pictures of a rubric by the student's own functions. A step that goes wrong is
/// shown as it went: the mesh as it was left behind, or the one before, and what the judge
/// says.
/// @param program  is built
/// @param say      is told of each picture when it is there
Writeup make_writeup(const WriteupRubric& rubric, StudentProgram& program,
                     const WriteupSetup& setup,
                     const std::function<void(const WriteupPicture&)>& say);

/// Whether anything went wrong.
bool is_right(const Writeup& writeup);

}  // namespace meshgrade
