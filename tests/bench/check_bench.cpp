#include "tests/bench/check_bench.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <thread>

#include "tests/bench/bare_compile.h"

namespace meshgrade::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCheck = "meshgrade check";
constexpr const char* kOneByOne = "bare compile, one by one";
constexpr const char* kAllCores = "bare compile, on all cores";

std::vector<fs::path> reference_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(MESHGRADE_SOURCE_DIR "/reference")) {
    if (entry.path().extension() == ".cpp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Real seconds. The processor time of what runs in the sandbox comes to nobody's account.
template <class Work>
std::function<double()> timed(Work work) {
  return [work] {
    const double began = seconds(Clock::kReal);
    work();
    return seconds(Clock::kReal) - began;
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
  const auto runs = interleave<double>(
      quick ? 3 : 9, {timed(check), timed([] { compile_all(reference_files(), 1); }),
                      timed([n_cores] { compile_all(reference_files(), n_cores); })});
  Table table{"check", "check of the reference: seconds", kAllCores, {"real time"}, {}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    table.row(names[i]).cells = {runs[i]};
  }
  return table;
}

std::vector<Goal> check_goals() {
  return {{"check", kCheck, kAllCores, "real time", 1.5},
          {"check", kCheck, kOneByOne, "real time", 1.5}};
}

}  // namespace meshgrade::bench
