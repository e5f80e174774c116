#include "grader/build/workshop.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/sandbox/confined_run.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMegabyte = 1U << 20U;
constexpr std::uint64_t kMostMessages = 64 * kMegabyte;
constexpr std::uint64_t kOpenFiles = 256;
constexpr std::uint64_t kProcesses = 32;  // the compiler, the assembler, the linker and theirs

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

Workshop::Workshop(const Home& home, const Limits& limits)
    : home_(&home), limits_(&limits), scratch_(std::in_place), folder_(scratch_->path()) {}

Workshop::Workshop(const Home& home, const Limits& limits, fs::path folder)
    : home_(&home), limits_(&limits), folder_(std::move(folder)) {}

void Workshop::put(const std::string& name, const std::string& text) const {
  const fs::path file = folder_ / name;
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw GraderError("cannot write " + file.string());
  fs::permissions(file, fs::perms(0644));  // for whoever may enter the folder
}

ProcessResult Workshop::run(std::vector<std::string> arguments, const std::string& made) const {
  fs::remove(folder_ / made);
  Command command;
  command.arguments = std::move(arguments);
  command.folder = folder_;
  command.time_limit = std::chrono::seconds(limits_->compile_seconds);
  command.kept_output = 64U << 10U;
  command.most_output = kMostMessages;
  Bounds bounds;
  bounds.compiles = true;
  bounds.writes_folder = true;
  bounds.readable = {home_->kit, home_->include};
  // More than the time on the clock, which tells by itself that it was used up.
  bounds.cpu_seconds = limits_->compile_seconds + 5;
  bounds.memory_bytes = limits_->compile_memory_mb * kMegabyte;
  bounds.file_bytes = limits_->object_mb * kMegabyte;
  bounds.open_files = kOpenFiles;
  bounds.processes = kProcesses;
  ProcessResult result = run_confined(home_->sandbox, std::move(command), bounds);
  result.output = clean(std::move(result.output));
  return result;
}

void Workshop::hand_over(const std::string& name, const fs::path& to) const {
  const fs::path made = folder_ / name;
  // By its descriptor: a name could be made to lead elsewhere between two looks at it.
  const FileDescriptor file(
      ::open(made.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode) ||
      ::fchmod(file.get(), 0644) != 0) {
    throw GraderError("the compiler has made no ordinary file " + name);
  }
  fs::rename(made, to / name);
}

/// Compiler messages without the machine's paths.
std::string Workshop::clean(std::string messages) const {
  replace_all(messages, folder_.string() + "/", "");
  replace_all(messages, home_->include.string() + "/", "");
  replace_all(messages, home_->kit.string() + "/", "");
  return printable(messages);
}

std::string complaints(const ProcessResult& result, const Limits& limits) {
  if (result.timed_out) {
    return "compiling took longer than " + std::to_string(limits.compile_seconds) +
           " seconds and was stopped\n";
  }
  if (result.too_much_output) return "the compiler had too much to say and was stopped\n";
  if (result.too_many_processes) return "compiling took too many processes and was stopped\n";
  if (!result.ok() && result.output.empty()) return "the compiler ended without a message\n";
  return result.output;
}

}  // namespace meshgrade
