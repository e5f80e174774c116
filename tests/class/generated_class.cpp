#include "tests/class/generated_class.h"

#include <algorithm>
#include <functional>

#include "grader/base/safe_file.h"
#include "tests/grade/expectation.h"
#include "tests/support/made_archive.h"
#include "tests/support/scratch_files.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = MESHGRADE_SOURCE_DIR;

/// A kind of submission: its name, how it is made, and what must come of it.
struct KindOfWork {
  std::string name;
  std::function<void(const fs::path& folder)> make;
  std::string status;
  PointsRange points;
  std::string verdict;
};

void copy_sources(const fs::path& from, const fs::path& to) {
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    if (entry.path().extension() != ".toml") fs::copy(entry.path(), to);
  }
}

std::string reference_flip() {
  return read_whole_file(kSource / "reference" / "edge_flip.cpp");
}

KindOfWork right(const std::string& name, const std::function<void(const fs::path&)>& make) {
  return {name, make, "graded", {20, 20}, "passed"};
}

KindOfWork ungradable(const std::string& name,
                      const std::function<void(const fs::path&)>& make) {
  return {name, make, "ungradable", {0, 0}, ""};
}

KindOfWork zero(const std::string& name, const std::string& verdict, const std::string& text) {
  return {name,
          [text](const fs::path& f) { write_file(f / "edge_flip.cpp", text); },
          "graded",
          {0, 0},
          verdict};
}

PointsRange expected_points(const Expectation& expected) {
  const double least = expected.points.value_or(-1.0);
  return {least, expected.most_points.value_or(least)};
}

void add_known_wrong(std::vector<KindOfWork>& kinds) {
  for (const fs::directory_entry& entry :
       fs::directory_iterator(kSource / "tests" / "submissions" / "wrong" / "edge_flip")) {
    const fs::path from = entry.path();
    const Expectation expected = read_expectation(from);
    kinds.push_back({from.lexically_relative(kSource / "tests" / "submissions").string(),
                     [from](const fs::path& folder) { copy_sources(from, folder); }, "graded",
                     expected_points(expected), expected.verdict});
  }
}

void add_right(std::vector<KindOfWork>& kinds) {
  kinds.push_back(right("reference", [](const fs::path& folder) {
    write_file(folder / "edge_flip.cpp", reference_flip());
  }));
  kinds.push_back(right("in an archive", [](const fs::path& folder) {
    make_archive(folder / "hw.zip",
                 {{"hw/src.txt", "x"}, {"hw/edge_flip.cpp", reference_flip()}});
  }));
  kinds.push_back(right("in an archive in an archive", [](const fs::path& folder) {
    make_archive(folder / "a.tar.gz", {{"edge_flip.cpp", reference_flip()}});
    const std::string inner = read_whole_file(folder / "a.tar.gz");
    fs::remove(folder / "a.tar.gz");
    make_archive(folder / "b.7z", {{"a.tar.gz", inner}});
  }));
  kinds.push_back(right("beside a file that does not compile", [](const fs::path& folder) {
    write_file(folder / "edge_flip.cpp", reference_flip());
    write_file(folder / "edge_split.cpp", "this is no C++");
  }));
}

/// Files that do not compile and hold no word of the function: to the grader, it is missing.
void add_hostile(std::vector<KindOfWork>& kinds) {
  kinds.push_back(zero("garbage", "not compiled", std::string("\x00\xFF\x1B[2J\x07{{{", 9)));
  kinds.push_back(zero("includes itself", "not compiled", "#include __FILE__\n"));
  kinds.push_back(zero("includes a device", "not compiled",
                       "#include \"/dev/null\"\n#error \033[31m ::error::forged\n"));
  kinds.push_back(
      zero("ends before main", "crashed",
           "#include <cstdlib>\nstatic int x = (std::_Exit(0), 1);\n" + reference_flip()));
}

void add_ungradable(std::vector<KindOfWork>& kinds) {
  kinds.push_back(ungradable("empty", [](const fs::path&) {}));
  kinds.push_back(ungradable("essay", [](const fs::path& folder) {
    write_file(folder / "essay.docx", "Dear grader");
  }));
  kinds.push_back(ungradable("link", [](const fs::path& folder) {
    fs::create_symlink("/etc/passwd", folder / "edge_flip.cpp");
  }));
  kinds.push_back(ungradable("encrypted", [](const fs::path& folder) {
    make_archive(folder / "hw.zip", {{"edge_flip.cpp", reference_flip()}}, "secret");
  }));
  kinds.push_back(ungradable("truncated", [](const fs::path& folder) {
    const fs::path file =
        make_archive(folder / "hw.zip", {{"edge_flip.cpp", reference_flip()}});
    fs::resize_file(file, fs::file_size(file) / 2);
  }));
  kinds.push_back(ungradable("leads out", [](const fs::path& folder) {
    make_archive(folder / "hw.tar", {{"../../../edge_flip.cpp", reference_flip()}});
  }));
}

/// All kinds, dealt in turn from each group, so that the first few hold some of every group.
std::vector<KindOfWork> all_kinds() {
  std::vector<std::vector<KindOfWork>> groups(4);
  add_known_wrong(groups[0]);
  std::sort(groups[0].begin(), groups[0].end(),
            [](const KindOfWork& a, const KindOfWork& b) { return a.name < b.name; });
  add_right(groups[1]);
  add_hostile(groups[2]);
  add_ungradable(groups[3]);
  std::size_t count = 0;
  for (const std::vector<KindOfWork>& group : groups)
    count += group.size();
  std::vector<KindOfWork> kinds;
  for (std::size_t i = 0; kinds.size() < count; ++i) {
    for (const std::vector<KindOfWork>& group : groups) {
      if (i < group.size()) kinds.push_back(group[i]);
    }
  }
  return kinds;
}

}  // namespace

std::vector<GeneratedStudent> generate_class(const fs::path& folder, std::size_t count) {
  const std::vector<KindOfWork> kinds = all_kinds();
  std::vector<GeneratedStudent> students;
  for (std::size_t i = 0; i < count; ++i) {
    const KindOfWork& kind = kinds[i % kinds.size()];
    const std::string digits = std::to_string(1000 + i).substr(1);
    const fs::path own = folder / ("student" + digits);
    fs::create_directories(own);
    kind.make(own);
    students.push_back(
        {"student" + digits, kind.name, own, kind.status, kind.points, kind.verdict});
  }
  return students;
}

fs::path write_class_assignment(const fs::path& file) {
  return write_file(file, R"(version = 1
title = "A class"
seed = 184
[limits]
compile_seconds = 20
case_cpu_ms = 500
case_wall_ms = 2500
memory_mb = 512
[[exercise]]
name = "edge_flip"
[[exercise.group]]
name = "basic"
points = 14
partial = "pointers"
[[exercise.group]]
name = "boundary"
points = 3
needs = "basic"
[[exercise.group]]
name = "stress"
points = 3
)");
}

}  // namespace meshgrade
