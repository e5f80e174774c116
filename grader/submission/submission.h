#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"

namespace meshgrade {

/// A text file of a submission.
struct SourceFile {
  std::string name;  ///< without folder
  std::string text;
};

/// The skeleton that the files were written for.
enum class Dialect {
  kMeshedit,      ///< ours
  kCourse2016,    ///< Berkeley's of 2016, with Bezier functions of another form
  kCourse2017,    ///< Berkeley's of 2017 to 2019
  kCourse2020,    ///< Berkeley's since 2020
  kScotty3d,      ///< Carnegie Mellon's Scotty3D since Fall 2022
  kScotty3d2020,  ///< Scotty3D of Fall 2020 to Spring 2022, and Stanford's Cardinal3D
};

/// Whether it is one of Berkeley's, or one of Scotty3D's.
bool is_berkeleys(Dialect dialect);
bool is_scotty3d(Dialect dialect);

/// What was handed in, as far as it is looked at: the sources to compile and the headers that
/// may come along. A copy in memory, so that later changes on disk do not matter.
struct Submission {
  std::string name;
  std::filesystem::path folder;
  std::vector<SourceFile> sources;
  std::vector<SourceFile> headers;
  Dialect dialect = Dialect::kMeshedit;
  std::vector<SourceFile> course_sources;  ///< a course's own, handed in along; not compiled
  std::vector<SourceFile> course_headers;  ///< likewise; the grader has its own instead
  std::vector<std::string> notes;          ///< what was recognised; what was left out, and why
};

/// The student's own files, which live as long as the submission: the sources, then the
/// headers.
std::vector<const SourceFile*> own_files(const Submission& submission);

/// Whether a file of this name is a C++ source file: .cpp, .cc, .cxx.
bool is_source_name(const std::filesystem::path& file);
/// Whether it is a header: .h, .hpp, .hh.
bool is_header_name(const std::filesystem::path& file);

/// Collects the C++ files of a folder or an archive, or a single file. Folders below are not
/// searched, but when the folder holds nothing than one other folder, that one is taken, and in
/// the project of a course the folder that holds the file which students hand in. A single
/// archive in a folder without C++ files is opened, and once more one within that. Links,
/// devices and files that are too large are left out with a note.
/// @throws UserError if there is nothing to grade, or an archive cannot be opened
Submission find_submission(const std::filesystem::path& path, const SubmissionRules& rules);

}  // namespace meshgrade
