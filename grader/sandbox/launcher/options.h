#pragma once

// The launcher gives up rights and then becomes another program:
//
//   meshgrade-launcher [OPTION VALUE]... -- PROGRAM [ARGUMENT]...
//
//   --report N       file descriptor N gets one line: "started", or what went wrong. The
//                    program does not inherit it
//   --supervise yes  stay behind as the parent: when the program ends, or on SIGTERM, end all
//                    that it left behind, then end as the program did
//   --user N         become this user and group, and lose all capabilities
//   --cpu SECONDS    of processor time, for each process
//   --memory BYTES   of address space, for each process
//   --file BYTES     the largest file
//   --processes N    processes and threads of this user (in this user namespace)
//   --open-files N   open files of a process
//   --read PATH      this file, or all below this folder, may be read
//   --run PATH       ... read and executed
//   --write PATH     ... read, written, made and removed
//   --signals own    signals reach only processes that are launched along (Landlock 6)
//   --calls few      system calls that a submission never needs fail (seccomp)
//
// What is not given is not limited. Once --read, --run or --write is given, nothing but what
// they name can be opened (Landlock). Each step is done or the program is not started.

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace meshgrade::launcher {

/// The program cannot be started as asked.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A refusal that ends with the reason of the last system call.
[[noreturn]] void refuse(const std::string& what);

struct Options {
  bool supervise = false;
  bool own_signals = false;
  bool few_calls = false;
  std::optional<std::uint64_t> report;
  std::optional<std::uint64_t> user;
  std::optional<std::uint64_t> cpu_seconds;
  std::optional<std::uint64_t> memory_bytes;
  std::optional<std::uint64_t> file_bytes;
  std::optional<std::uint64_t> processes;
  std::optional<std::uint64_t> open_files;
  std::vector<std::string> read;
  std::vector<std::string> run;
  std::vector<std::string> write;
  std::vector<char*> program;  ///< ends with a nullptr

  bool bounds_files() const { return !read.empty() || !run.empty() || !write.empty(); }
};

/// @throws Refusal for what is not an option, or has no value
Options read_options(int argc, char** argv);

}  // namespace meshgrade::launcher
