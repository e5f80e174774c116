#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "grader/base/process.h"
#include "grader/sandbox/sandbox.h"

namespace meshgrade {

/// What a confined program may do beyond computing. The folder that it runs in is its own while
/// it runs; next to it, it sees the system's libraries.
struct Bounds {
  bool compiles = false;         ///< may run the system's programs, and read its headers
  bool writes_folder = false;    ///< may write in its folder; else it can only read it
  bool reads_processes = false;  ///< may read /proc: the sanitizers do
  std::vector<std::filesystem::path> readable;  ///< more files and folders to read
  // Limits of one process. 0: none.
  std::uint64_t cpu_seconds = 0;
  std::uint64_t memory_bytes = 0;  ///< of address space
  std::uint64_t file_bytes = 0;    ///< the largest file
  std::uint64_t open_files = 0;
  std::uint64_t processes = 0;  ///< all together, threads among them
};

/// Runs a program within these bounds, as tightly as the sandbox can, and ends all that it left
/// behind. It gets a fixed environment, and the command's shared files. `command.folder` must
/// be a folder that nothing else uses while it runs; it belongs to this process again after.
/// @throws GraderError if it cannot be started confined as the sandbox promises
ProcessResult run_confined(const Sandbox& sandbox, Command command, const Bounds& bounds);

}  // namespace meshgrade
