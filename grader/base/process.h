#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meshgrade {

/// A file descriptor that closes itself.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int fd) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor();

  int get() const { return fd_; }

 private:
  int fd_ = -1;
};

/// A nameless temporary file, open for reading and writing.
/// @throws GraderError if there is no room for one
FileDescriptor make_scratch_file();

/// A temporary folder that deletes itself with all it holds, also where a signal ends the
/// program in order (interrupt.h).
class ScratchFolder {
 public:
  /// @throws GraderError if it cannot be made
  ScratchFolder();
  ScratchFolder(ScratchFolder&& other) noexcept : path_(std::move(other.path_)) {
    other.path_.clear();
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A program to run. It gets no input and shares no descriptor but those named here.
struct Command {
  std::vector<std::string> arguments;  ///< the program first; looked up in PATH
  std::filesystem::path folder;        ///< where it runs; empty: here
  std::string input;                   ///< its standard input
  std::vector<int> shared_files;       ///< become descriptors 3, 4, ... of the program
  std::chrono::milliseconds time_limit{60'000};
  std::size_t kept_output = 1U << 20U;  ///< bytes of output that are kept; the rest is dropped
  std::optional<std::vector<std::string>> environment;  ///< "NAME=value"; else as it is here
  bool ends_its_own = false;  ///< asked to by SIGTERM, it ends all that it has started
  // Limits that end the program, together with all that it has started. 0: none. Memory and
  // processes are looked at every few milliseconds, on Linux.
  std::uint64_t most_memory = 0;   ///< bytes of real memory, not counting files
  std::size_t most_processes = 0;  ///< processes and threads
  std::uint64_t most_output = 0;   ///< bytes of output
};

/// How a program ended.
struct ProcessResult {
  bool timed_out = false;
  bool out_of_memory = false;
  bool too_many_processes = false;
  bool too_much_output = false;
  int signal = 0;      ///< the signal that ended it, or 0
  int status = 0;      ///< the exit status if no signal did
  std::string output;  ///< what it wrote to standard output and standard error

  /// It was ended because it reached a limit.
  bool stopped() const {
    return timed_out || out_of_memory || too_many_processes || too_much_output;
  }
  bool ok() const { return !stopped() && signal == 0 && status == 0; }
};

/// Runs a program to its end, or to a limit, when it and its process group are killed.
/// @throws GraderError if it cannot be started at all
/// @throws Interrupted if this program is to end: then the other has ended already
/// @throws Cancelled if another thread asks for that: likewise
ProcessResult run_process(const Command& command);

}  // namespace meshgrade
