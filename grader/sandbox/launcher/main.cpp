#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "grader/sandbox/launcher/confine.h"
#include "grader/sandbox/launcher/options.h"
#include "grader/sandbox/launcher/supervisor.h"

namespace meshgrade::launcher {
namespace {

constexpr int kFailed = 125;

void tell(const std::optional<std::uint64_t>& report, const std::string& line) {
  if (!report) return;
  const ssize_t ignored = ::write(static_cast<int>(*report), line.data(), line.size());
  static_cast<void>(ignored);
}

[[noreturn]] void launch(const Options& options) {
  ::umask(022);  // what one user makes is for the next one to read
  if (options.supervise) supervise(options.user);
  change_user(options);
  if (options.supervise) end_with_parent(SIGKILL);
  limit_resources(options);
  if (options.bounds_files() || options.few_calls) forbid_new_privileges();
#ifdef __linux__
  if (options.bounds_files()) bound_files(options);
  if (options.few_calls) filter_calls();
#endif
  tell(options.report, "started\n");
  ::execvp(options.program[0], options.program.data());
  refuse(std::string("cannot run ") + options.program[0]);
}

}  // namespace
}  // namespace meshgrade::launcher

int main(int argc, char** argv) {
  using namespace meshgrade::launcher;
  std::optional<std::uint64_t> report;
  try {
    const Options options = read_options(argc, argv);
    report = options.report;
    if (report && ::fcntl(static_cast<int>(*report), F_SETFD, FD_CLOEXEC) != 0) {
      refuse("nowhere to report to");
    }
    launch(options);
  } catch (const std::exception& error) {
    tell(report, std::string(error.what()) + "\n");
    std::fprintf(stderr, "meshgrade-launcher: %s\n", error.what());
    return kFailed;
  }
}
