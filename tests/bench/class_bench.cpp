#include "tests/bench/class_bench.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <thread>

#include "grader/base/process.h"

namespace meshgrade::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBatch = "meshgrade batch";
constexpr const char* kBefore = "meshgrade batch, before";
constexpr const char* kBare = "bare compile";
constexpr const char* kUsual = "CMake and GoogleTest";
constexpr const char* kColumn = "per submission";

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The known-wrong submissions of one file that are judged to their end: those that run out of
/// time would measure the limit.
std::vector<fs::path> wrong_files() {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(MESHGRADE_SOURCE_DIR "/tests/submissions/wrong")) {
    if (entry.path().extension() != ".cpp") continue;
    const fs::path reference =
        fs::path(MESHGRADE_SOURCE_DIR "/reference") / entry.path().filename();
    const std::string expected = text_of(entry.path().parent_path() / "expected.toml");
    if (fs::exists(reference) && expected.find("verdict = \"failed\"") != std::string::npos)
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// No two hand-ins have a file in common: each begins with its student's name.
std::vector<fs::path> make_class(const fs::path& folder, std::size_t count) {
  const std::vector<fs::path> wrong = wrong_files();
  std::vector<fs::path> hand_ins;
  for (std::size_t i = 0; i < count; ++i) {
    hand_ins.push_back(folder / ("student" + std::to_string(i)));
    fs::create_directories(hand_ins.back());
    const auto put = [&](const fs::path& file) {
      std::ofstream(hand_ins.back() / file.filename())
          << "// " << hand_ins.back().filename().string() << "\n"
          << text_of(file);
    };
    for (const auto& entry : fs::directory_iterator(MESHGRADE_SOURCE_DIR "/reference")) {
      if (entry.path().extension() == ".cpp") put(entry.path());
    }
    put(wrong[i % wrong.size()]);
  }
  return hand_ins;
}

std::vector<fs::path> files_of(const std::vector<fs::path>& hand_ins) {
  std::vector<fs::path> files;
  for (const fs::path& hand_in : hand_ins) {
    for (const auto& entry : fs::directory_iterator(hand_in))
      files.push_back(entry.path());
  }
  return files;
}

void grade_by_googletest(const std::vector<fs::path>& hand_ins) {
  for (const fs::path& hand_in : hand_ins) {
    const ScratchFolder folder;
    const std::string build = folder.path();
    run_or_throw({"cmake", "-S", MESHGRADE_SOURCE_DIR "/tests/bench/usual_way", "-B", build,
                  "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DHAND_IN=" + hand_in.string(),
                  "-DSHARED_HEADERS=" MESHGRADE_SOURCE_DIR "/include"});
    run_or_throw({"ninja", "-C", build});
    run_or_throw({build + "/grading_tests"}, 1);  // 1: a test has failed
  }
}

/// Seconds per submission of a run over all of them.
std::function<double()> per_submission(std::size_t count, std::function<void()> work) {
  return [count, work = std::move(work)] {
    const double began = seconds(Clock::kReal);
    work();
    return (seconds(Clock::kReal) - began) / static_cast<double>(count);
  };
}

}  // namespace

Table run_class_bench(const Programs& programs, bool quick) {
  std::cerr << "measuring: class\n";
  const ScratchFolder folder;
  const fs::path submissions = folder.path() / "class";
  const std::vector<fs::path> all = make_class(submissions, quick ? 10 : 200);
  // The slower ways need no 200 to tell what one submission takes.
  const std::vector<fs::path> some(all.begin(), all.begin() + (quick ? 5 : 40));
  const std::vector<fs::path> few(all.begin(), all.begin() + (quick ? 1 : 4));
  const unsigned n_cores = std::max(1U, std::thread::hardware_concurrency());
  const auto batch_by = [&](const fs::path& program) {
    return per_submission(all.size(), [&, program] {
      const ScratchFolder results;
      run_or_throw({program.string(), "batch", submissions.string(), "-o",
                    (results.path() / "results").string()});
    });
  };
  std::vector<std::function<double()>> contestants{
      batch_by(programs.now),
      per_submission(some.size(), [&] { compile_all(files_of(some), n_cores); }),
      per_submission(few.size(), [&] { grade_by_googletest(few); })};
  if (!programs.before.empty()) contestants.push_back(batch_by(programs.before));
  const auto runs = interleave<double>(quick ? 1 : 3, contestants);
  Table table{"class",
              "a class of " + std::to_string(all.size()) + ": real seconds",
              kBare,
              {kColumn},
              {}};
  table.row(kBatch).cells = {runs[0]};
  table.row(kBare).cells = {runs[1]};
  table.row(kUsual).cells = {runs[2]};
  if (runs.size() > 3) table.row(kBefore).cells = {runs[3]};
  return table;
}

std::vector<Goal> class_goals() {
  return {{"class", kBatch, kBare, kColumn, 0.45},
          {"class", kBatch, kUsual, kColumn, 6.0, Goal::kAtLeast}};
}

}  // namespace meshgrade::bench
