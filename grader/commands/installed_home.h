#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "grader/base/process.h"

namespace meshgrade {

/// `share/meshgrade` beside the folder `bin` that this program runs from; empty if this program
/// was built where it is, and not installed.
std::filesystem::path installed_share();

/// The C++ compiler of the person who runs an installed program: $CXX, else c++.
/// @throws UserError if there is none
std::string installed_compiler();

/// A kit (compiler flags, the worker, headers) that fits a compiler.
struct ReadyKit {
  std::filesystem::path folder;
  std::shared_ptr<ScratchFolder> scratch;  ///< that holds it, where nothing can be kept
};

/// An installed kit comes without precompiled headers, since they fit one compiler only. They
/// are made at the first use, in a copy below $XDG_CACHE_HOME/meshgrade or ~/.cache/meshgrade
/// (for root /var/cache/meshgrade). What is there is taken only if it is whole and nobody else
/// can write to it. Says on standard error what takes time.
/// @throws UserError if the compiler cannot compile the shared headers
ReadyKit ready_kit(const std::filesystem::path& shipped, const std::filesystem::path& include,
                   const std::string& compiler);

}  // namespace meshgrade
