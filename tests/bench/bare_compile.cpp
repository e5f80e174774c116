#include "tests/bench/bare_compile.h"

#include <atomic>
#include <thread>

#include "grader/base/errors.h"
#include "grader/base/process.h"

namespace meshgrade::bench {

void run_or_throw(std::vector<std::string> arguments, int most_status) {
  Command command;
  command.arguments = std::move(arguments);
  command.time_limit = std::chrono::hours(2);
  const ProcessResult result = run_process(command);
  if (result.signal != 0 || result.timed_out || result.status > most_status)
    throw GraderError("the benchmark's command failed: " + result.output);
}

void compile_all(const std::vector<std::filesystem::path>& files, unsigned n_cores) {
  const ScratchFolder folder;
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> threads;
  for (unsigned core = 0; core < n_cores; ++core) {
    threads.emplace_back([&, core] {
      const std::string object = folder.path() / (std::to_string(core) + ".o");
      for (std::size_t k = next++; k < files.size(); k = next++) {
        run_or_throw({MESHGRADE_COMPILER, "@" MESHGRADE_KIT_DIR "/flags.txt",
                      "-I" MESHGRADE_SOURCE_DIR "/include", "-c", files[k].string(), "-o",
                      object});
      }
    });
  }
}

}  // namespace meshgrade::bench
