#include "tests/bench/check_bench.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <iostream>
#include <thread>

#include "grader/base/errors.h"
#include "grader/base/process.h"

namespace meshgrade::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCheck = "meshgrade check";
constexpr const char* kOneByOne = "bare compile, one by one";
constexpr const char* kAllCores = "bare compile, on all cores";

void run_or_throw(std::vector<std::string> arguments) {
  Command command;
  command.arguments = std::move(arguments);
  const ProcessResult result = run_process(command);
  if (!result.ok()) throw GraderError("the benchmark's command failed: " + result.output);
}

std::vector<fs::path> reference_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(MESHGRADE_SOURCE_DIR "/reference")) {
    if (entry.path().extension() == ".cpp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The files go to the next free one of `n_cores` threads.
void compile_all(unsigned n_cores) {
  const ScratchFolder folder;
  const std::vector<fs::path> files = reference_files();
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < n_cores; ++i) {
    threads.emplace_back([&] {
      for (std::size_t k = next++; k < files.size(); k = next++) {
        const fs::path object = folder.path() / (files[k].filename().string() + ".o");
        run_or_throw({MESHGRADE_COMPILER, "@" MESHGRADE_KIT_DIR "/flags.txt",
                      "-I" MESHGRADE_SOURCE_DIR "/include", "-c", files[k].string(), "-o",
                      object.string()});
      }
    });
  }
}

double processor_seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto in_seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return in_seconds(usage.ru_utime) + in_seconds(usage.ru_stime);
}

struct Seconds {
  double real = 0.0;
  double processor = 0.0;
};

template <class Work>
std::function<Seconds()> timed(Work work) {
  return [work] {
    const double real = seconds(Clock::kReal);
    const double processor = processor_seconds_of_children();
    work();
    return Seconds{seconds(Clock::kReal) - real, processor_seconds_of_children() - processor};
  };
}

}  // namespace

Table run_check_bench(const fs::path& program, bool quick) {
  std::cerr << "measuring: check\n";
  const unsigned n_cores = std::max(1U, std::thread::hardware_concurrency());
  const auto check = [&] {
    run_or_throw({program.string(), "check", MESHGRADE_SOURCE_DIR "/reference"});
  };
  const std::array<const char*, 3> names{kCheck, kOneByOne, kAllCores};
  const auto runs =
      interleave<Seconds>(quick ? 3 : 9, {timed(check), timed([] { compile_all(1); }),
                                          timed([n_cores] { compile_all(n_cores); })});
  Table table{"check",
              "check of the reference: seconds",
              kAllCores,
              {"real time", "processor time"},
              {}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Row& row = table.row(names[i]);
    row.cells.resize(2);
    for (const Seconds& taken : runs[i]) {
      row.cells[0].push_back(taken.real);
      row.cells[1].push_back(taken.processor);
    }
  }
  return table;
}

std::vector<Goal> check_goals() {
  return {{"check", kCheck, kAllCores, "real time", 1.5},
          {"check", kCheck, kAllCores, "processor time", 1.5},
          {"check", kCheck, kOneByOne, "real time", 1.5}};
}

}  // namespace meshgrade::bench
