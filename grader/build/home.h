#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "grader/base/kept_files.h"
#include "grader/base/process.h"
#include "grader/base/stage_times.h"
#include "grader/sandbox/sandbox.h"

namespace meshgrade {

/// Results of earlier calls, and what they depend on beside the submission: this program, its
/// kit, the compiler and the sandbox.
struct KeptWork {
  KeptWork(const std::filesystem::path& folder, std::uint64_t most, std::string around)
      : files(folder, most), surroundings(std::move(around)) {}

  KeptFiles files;
  std::string surroundings;  ///< digest
};

/// Where the program's own files are.
struct Home {
  std::filesystem::path include;  ///< the folder that holds meshedit/
  std::filesystem::path kit;      ///< compiler flags, precompiled headers, the worker's objects
  std::filesystem::path meshes;   ///< the meshes that cases are made from
  std::filesystem::path docs;
  /// The model solution, which stands in for what a submission lacks; empty in a package that
  /// comes without it.
  std::filesystem::path reference;
  std::string compiler;                   ///< the C++ compiler for submissions
  Sandbox sandbox;                        ///< in which submissions are compiled and run
  std::shared_ptr<ScratchFolder> copies;  ///< of include and kit, where they must be copied
  std::shared_ptr<ScratchFolder> own_kit = nullptr;  ///< the kit, where it could not be kept
  std::shared_ptr<StageTimes> times = nullptr;  ///< where to say how long what took; or nowhere
  std::shared_ptr<const KeptWork> kept = nullptr;  ///< for submissions that are checked again
  std::size_t cores = 0;    ///< to use for one submission; 0: all of them
  bool joins_files = true;  ///< compiles as one what is the same in one; see joining.h
};

/// How many programs for one submission may run at once, at least 1.
std::size_t cores_of(const Home& home);

}  // namespace meshgrade
