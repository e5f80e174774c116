#include "tests/bench/setup_bench.h"

#include <sys/resource.h>

#include <iostream>

#include "grader/base/errors.h"
#include "grader/base/process.h"

namespace meshgrade::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNow = "first check";
constexpr const char* kBefore = "first check, before";

/// The sources of a program in their folder `build`, at whatever depth.
fs::path sources_of(const fs::path& program) {
  for (fs::path folder = fs::canonical(program); folder.has_relative_path();
       folder = folder.parent_path()) {
    if (folder.filename() == "build") return folder.parent_path();
  }
  throw UserError(program.string() + ": it does not lie in the build folder of its sources");
}

/// All of a checkout but what was built in it.
void copy_sources(const fs::path& from, const fs::path& to) {
  fs::create_directories(to);
  for (const auto& entry : fs::directory_iterator(from)) {
    const std::string name = entry.path().filename().string();
    if (name == "build" || name == ".git") continue;
    fs::copy(entry.path(), to / name, fs::copy_options::recursive);
  }
}

double processor_time_of_children() {
  struct rusage usage {};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto in_seconds = [](const struct timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return in_seconds(usage.ru_utime) + in_seconds(usage.ru_stime);
}

std::size_t count_objects(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    count += entry.path().extension() == ".o" ? 1 : 0;
  return count;
}

std::vector<Samples> first_check(const fs::path& sources) {
  std::cerr << "measuring: the first check in a copy of " << sources.string() << "\n";
  const ScratchFolder scratch;
  const fs::path copy = scratch.path() / "meshgrade";
  copy_sources(sources, copy);
  const double began = processor_time_of_children();
  run_or_throw({"env", "XDG_CACHE_HOME=" + (scratch.path() / "cache").string(),
                (copy / "meshgrade").string(), "check", "reference"});
  const double took = processor_time_of_children() - began;
  return {{took}, {static_cast<double>(count_objects(copy / "build"))}};
}

}  // namespace

Table run_setup_bench(const Programs& programs) {
  Table table{"setup",
              "from clean sources to the first verdict, once",
              kNow,
              {"processor seconds", "objects"},
              {}};
  table.row(kNow).cells = first_check(sources_of(programs.now));
  if (!programs.before.empty())
    table.row(kBefore).cells = first_check(sources_of(programs.before));
  return table;
}

std::vector<Goal> setup_goals() {
  return {{"setup", kNow, kBefore, "processor seconds", 1.0 / 3.0}};
}

}  // namespace meshgrade::bench
