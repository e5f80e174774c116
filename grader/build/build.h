#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/base/process.h"
#include "grader/build/diagnostics.h"
#include "grader/build/home.h"
#include "grader/build/leave_out.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// How one source file fared.
struct BuiltFile {
  std::string name;
  bool ok = false;
  /// Of the compiler or linker: the errors, or the warnings of a file that compiled whole.
  std::string messages;
  std::vector<CompilerWarning> warnings;  ///< of what was compiled in the end
  bool linked = true;          ///< false if it compiles, but not together with the other files
  bool compiler_died = false;  ///< the compiler broke, twice: not the student's fault
  std::vector<LeftOut> left_out;   ///< functions without which the file compiles
  std::vector<std::string> notes;  ///< what is known about the reasons

  template <class Wire>
  void transfer(Wire& wire) {
    wire(name, ok, messages, warnings, linked, compiler_died, left_out, notes);
  }
};

/// What a worker comes from: of the program and the submission.
struct BuildOrigin {
  std::string surroundings;         ///< digest of all but the sources
  std::vector<SourceFile> sources;  ///< of the submission
  bool is_divisible = true;         ///< false if every file may have a part in every function
};

/// A worker that contains the student's functions; those that are missing answer "not
/// implemented". The program lies in a scratch folder that lives as long as this value.
struct Build {
  ScratchFolder folder;
  std::filesystem::path worker;
  Sandbox sandbox;                    ///< in which the worker is to run
  std::optional<ScratchFolder> logs;  ///< where the sanitizers write what they find
  std::vector<BuiltFile> files;

  std::shared_ptr<StageTimes> times;     ///< as in Home
  std::shared_ptr<const KeptWork> kept;  ///< likewise
  BuildOrigin origin;                    ///< if something is kept

  const BuiltFile* find(const std::string& name) const;
};

/// What the student's files are compiled for. The worker around them is always the same.
enum class BuildKind {
  kGrading,
  kSanitized,  ///< with the address and undefined-behaviour sanitizers
  kDebug,      ///< without optimization, for a debugger
};

/// Compiles every source on its own, several at a time, and links what compiled. Functions that
/// do not compile are left out; a file that does not compile or link even so is left out and
/// takes no other file with it.
/// The compiler and the linker run in the home's sandbox; nothing of the submission is run.
/// @throws GraderError if not even the empty submission can be linked
Build build_submission(const Submission& submission, const Home& home, const Limits& limits,
                       BuildKind kind = BuildKind::kGrading);

}  // namespace meshgrade
