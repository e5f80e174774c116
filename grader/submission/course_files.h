#pragma once

#include <set>
#include <string>
#include <string_view>

#include "grader/submission/submission.h"

namespace meshgrade {

/// The functions that students of Berkeley's course write, of all years.
const std::set<std::string>& graded_functions();

/// Whether a file of Berkeley's MeshEdit homework is the course's own, handed in along with the
/// student's. It has the name of a file of the course's folder src, of any year from 2016 to
/// 2026, and holds nothing of the student's: a source that defines a graded function is the
/// student's whatever its name, and so is a file that includes student_code.h, which of the
/// course's only the program does.
bool is_course_file(const SourceFile& file);

/// Whether nothing was added to this file, which has to be handed in: a student_code.h that
/// declares MeshResampler as the course does.
bool is_as_handed_out(const SourceFile& file);

/// The text without space, but for one between two words.
std::string squeeze(std::string_view text);

/// Whether the text includes this header, in quotes or angle brackets, with or without a
/// folder.
bool includes(const std::string& text, const std::string& header);

}  // namespace meshgrade
