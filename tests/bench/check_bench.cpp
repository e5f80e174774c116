#include "tests/bench/check_bench.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <thread>

#include "grader/base/process.h"

namespace meshgrade::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCheck = "check, nothing kept";
constexpr const char* kBefore = "check, nothing kept, before";
constexpr const char* kUnchanged = "check of the same again";
constexpr const char* kChanged = "check after one changed file";
constexpr const char* kReplay = "replay of one case";
constexpr const char* kEndless = "check of a flip without an end";
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

/// A copy of the reference that a student works on, and the folder where checks keep things.
class Desk {
 public:
  Desk() {
    fs::copy(MESHGRADE_SOURCE_DIR "/reference", homework());
    fs::copy(homework(), endless());
    std::ofstream(endless() / "edge_flip.cpp")
        << "#include \"meshedit/meshedit.h\"\n"
           "meshedit::EdgeIter meshedit::HalfedgeMesh::flipEdge(EdgeIter e) {\n"
           "  volatile bool forever = true;\n"
           "  while (forever) {}\n"
           "  return e;\n"
           "}\n";
  }

  fs::path homework() const { return folder_.path() / "homework"; }
  fs::path endless() const { return folder_.path() / "endless"; }

  void call(const fs::path& program, std::vector<std::string> arguments, bool keeps,
            int most_status = 0) const {
    // No folder can be made below a device.
    const std::string cache = keeps ? (folder_.path() / "cache").string() : "/dev/null/none";
    const std::string state = (folder_.path() / "state").string();
    std::vector<std::string> words{"env", "XDG_CACHE_HOME=" + cache, "XDG_STATE_HOME=" + state,
                                   program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    run_or_throw(std::move(words), most_status);
  }

  void change_a_file() {
    std::ofstream(homework() / "edge_flip.cpp", std::ios::app) << "// " << ++saves_ << "\n";
  }

 private:
  ScratchFolder folder_;
  int saves_ = 0;
};

}  // namespace

Table run_check_bench(const Programs& programs, bool quick) {
  std::cerr << "measuring: check\n";
  const unsigned n_cores = std::max(1U, std::thread::hardware_concurrency());
  Desk desk;
  const std::string homework = desk.homework();
  const auto check = [&](const fs::path& program, bool keeps) {
    return timed([&desk, program, keeps, homework] {
      desk.call(program, {"check", homework}, keeps);
    });
  };
  const auto changed = [&] {
    desk.change_a_file();
    return check(programs.now, true)();
  };
  const auto replay = timed([&] {
    desk.call(programs.now, {"replay", "edge_split:basic/1", homework}, true);
  });
  const auto endless = timed([&] {
    desk.call(programs.now, {"check", desk.endless().string()}, false, 1);
  });
  std::vector<std::pair<const char*, std::function<double()>>> contestants{
      {kCheck, check(programs.now, false)},
      {kUnchanged, check(programs.now, true)},
      {kChanged, changed},
      {kReplay, replay},
      {kEndless, endless},
      {kOneByOne, timed([] { compile_all(reference_files(), 1); })},
      {kAllCores, timed([n_cores] { compile_all(reference_files(), n_cores); })}};
  if (!programs.before.empty())
    contestants.emplace_back(kBefore, check(programs.before, false));
  std::vector<std::function<double()>> works;
  for (const auto& contestant : contestants)
    works.push_back(contestant.second);
  const auto runs = interleave<double>(quick ? 3 : 9, works);
  Table table{"check", "what a student waits for: seconds", kAllCores, {"real time"}, {}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    table.row(contestants[i].first).cells = {runs[i]};
  }
  return table;
}

std::vector<Goal> check_goals() {
  return {{"check", kCheck, kAllCores, "real time", 0.45},
          {"check", kCheck, kBefore, "real time", 0.5},
          {"check", kChanged, kAllCores, "real time", 0.3},
          {"check", kReplay, kAllCores, "real time", 0.3}};
}

}  // namespace meshgrade::bench
