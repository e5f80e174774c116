#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/submission/submission.h"

namespace meshgrade {

/// Somebody who gets a grade, as far as the place where the work was handed in tells.
struct Person {
  std::string id;     ///< what the gradebook knows the person by; never empty
  std::string name;   ///< empty if not known
  std::string email;  ///< empty if not known
};

/// A file or folder that was handed in.
struct Part {
  std::filesystem::path path;
  std::string name;  ///< what the student called it
};

/// One piece of work and whose it is. A group hands in one for all its people.
struct HandIn {
  std::string key;  ///< unique in the roster: for messages, for --only, and for its folder
  std::vector<Person> people;
  std::vector<Part> parts;
  std::string submitted_at;  ///< as it was told; empty if not known
  bool late = false;         ///< only where the place says so
};

/// Something that is not graded, and why.
struct Omission {
  std::string what;
  std::string why;
};

/// Who handed in what.
struct Roster {
  std::string layout;              ///< "canvas"
  std::vector<HandIn> hand_ins;    ///< sorted by key
  std::vector<Omission> left_out;  ///< sorted by what
};

/// A way in which some platform arranges the work of a class in a folder.
struct Layout {
  const char* name;   ///< "canvas"
  const char* title;  ///< what it is, for --help
  /// Whether the folder looks like it.
  bool (*recognise)(const std::filesystem::path& folder);
  /// Adds what is found to the roster. @throws UserError if the folder is of another form
  void (*read)(const std::filesystem::path& folder, const std::string& assignment,
               Roster& roster);
};

/// All layouts, in the order in which they are tried; the last one takes any folder.
const std::vector<Layout>& layouts();

struct RosterOptions {
  std::string layout;      ///< the name of one; empty: the one that recognises the folder
  std::string assignment;  ///< which one, where the folder holds several; else empty
};

/// Finds out who handed in what.
/// @throws UserError if the folder cannot be read, or holds no hand-in at all
Roster read_roster(const std::filesystem::path& folder, const RosterOptions& options);

/// Brings the parts of a hand-in together.
/// @throws UserError if there is nothing to grade
Submission take_submission(const HandIn& hand_in, const SubmissionRules& rules);

/// A file name for the key, made of letters, digits and . _ - @ ~ only. Different keys have
/// different names, on file systems that ignore case as well.
std::string safe_file_name(const std::string& key);

}  // namespace meshgrade
