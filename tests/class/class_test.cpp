// A class gets exactly the points that it must get: at one and two jobs, after being killed at
// random moments, and from the layout of every platform. With MESHGRADE_WHOLE_CLASS set it is
// one of 200, killed at 20 moments, which takes some ten minutes; else a part of it.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <thread>

#include "grader/base/csv.h"
#include "grader/base/process.h"
#include "grader/base/safe_file.h"
#include "tests/class/generated_class.h"
#include "tests/support/made_archive.h"
#include "tests/support/scratch_files.h"

extern char** environ;

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

bool is_whole() {
  return std::getenv("MESHGRADE_WHOLE_CLASS") != nullptr;
}

const std::size_t kStudents = is_whole() ? 200 : 24;
const std::size_t kStudentsOfALayout = is_whole() ? 44 : 8;  // 44: every kind
const int kKills = is_whole() ? 20 : 5;

/// The class, made once for all tests.
class GeneratedClass : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch = new ScratchFolder();
    students = generate_class(scratch->path() / "class", kStudents);
    assignment = write_class_assignment(scratch->path() / "assignment.toml");
  }
  static void TearDownTestSuite() { delete scratch; }

  static std::vector<std::string> words(const fs::path& submissions, const fs::path& results,
                                        unsigned jobs) {
    return {MESHGRADE_PROGRAM,   "batch",        submissions.string(), "-o",
            results.string(),    "--assignment", assignment.string(),  "--jobs",
            std::to_string(jobs)};
  }

  static fs::path place(const std::string& name) { return scratch->path() / name; }

  /// Grades to the end.
  static void grade(const fs::path& submissions, const fs::path& results, unsigned jobs) {
    Command command;
    command.arguments = words(submissions, results, jobs);
    command.time_limit = std::chrono::minutes(28);
    const ProcessResult result = run_process(command);
    EXPECT_EQ(result.status, 1) << "some cannot be graded, none is a fault of the grader\n"
                                << result.output;
  }

  /// Grades, until it is killed after so long. @return whether it had come to its end before
  static bool grade_and_kill(const fs::path& submissions, const fs::path& results,
                             std::chrono::milliseconds delay) {
    std::vector<std::string> arguments = words(submissions, results, 2);
    std::vector<char*> argv;
    for (std::string& argument : arguments)
      argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t quiet;
    ::posix_spawn_file_actions_init(&quiet);
    ::posix_spawn_file_actions_addopen(&quiet, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = -1;
    EXPECT_EQ(::posix_spawn(&process, argv[0], &quiet, nullptr, argv.data(), environ), 0);
    ::posix_spawn_file_actions_destroy(&quiet);
    std::this_thread::sleep_for(delay);
    ::kill(process, SIGKILL);
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFEXITED(status);
  }

  struct Grade {
    std::string status;
    std::string points;
    std::string verdict;
  };

  /// What grades.csv says of each person.
  static std::map<std::string, Grade> grades(const fs::path& results) {
    std::map<std::string, Grade> all;
    const std::string bytes = read_whole_file(results / "grades.csv");
    const std::vector<CsvRecord> records = read_csv(bytes);
    std::map<std::string, std::size_t> column;
    for (std::size_t i = 0; i < records.at(0).size(); ++i)
      column[records[0][i].text] = i;
    for (std::size_t i = 1; i < records.size(); ++i) {
      const auto text = [&](const char* name) { return records[i].at(column.at(name)).text; };
      all[text("id")] = {text("status"), text("points"), text("edge_flip_verdict")};
    }
    return all;
  }

  /// `name` turns a student into the id that the layout gives.
  template <class Name>
  static void expect_known_points(const fs::path& results, std::size_t count, Name name) {
    const auto all = grades(results);
    EXPECT_EQ(all.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const GeneratedStudent& student = students[i];
      const auto found = all.find(name(student));
      ASSERT_NE(found, all.end()) << student.id << " is lost";
      EXPECT_EQ(found->second.status, student.status) << student.id << " " << student.kind;
      const double points = std::stod(found->second.points);
      EXPECT_GE(points, student.points.least) << student.id << " " << student.kind;
      EXPECT_LE(points, student.points.most) << student.id << " " << student.kind;
      EXPECT_EQ(found->second.verdict, student.verdict) << student.id << " " << student.kind;
    }
  }

  static std::string same_id(const GeneratedStudent& student) { return student.id; }

  static inline ScratchFolder* scratch = nullptr;
  static inline std::vector<GeneratedStudent> students;
  static inline fs::path assignment;
};

TEST_F(GeneratedClass, GetsItsPointsAtTwoJobs) {
  grade(place("class"), place("two"), 2);
  expect_known_points(place("two"), kStudents, same_id);
}

TEST_F(GeneratedClass, GetsItsPointsAtOneJob) {
  grade(place("class"), place("one"), 1);
  expect_known_points(place("one"), kStudents, same_id);
}

TEST_F(GeneratedClass, GetsItsPointsAfterBeingKilledAtRandomMoments) {
  std::mt19937 random(184);
  for (int i = 0; i < kKills; ++i) {
    grade_and_kill(place("class"), place("killed"),
                   std::chrono::milliseconds(100 + random() % 4000));
  }
  grade(place("class"), place("killed"), 2);
  expect_known_points(place("killed"), kStudents, same_id);
}

/// Brings the work of the first students into the form of a platform.
class ClassInLayout : public GeneratedClass {
 protected:
  template <class Place>
  static void arrange(const fs::path& to, Place place_of) {
    for (std::size_t i = 0; i < kStudentsOfALayout; ++i) {
      const fs::path own = to / place_of(students[i]);
      fs::create_directories(own);
      fs::copy(students[i].folder, own,
               fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    }
  }

  /// A single file as it is, else an archive: where a platform knows only files.
  template <class Start>
  static void arrange_files(const fs::path& to, Start start_of_name) {
    fs::create_directories(to);
    for (std::size_t i = 0; i < kStudentsOfALayout; ++i) {
      const std::string start = start_of_name(students[i]);
      std::vector<fs::path> files;
      for (const auto& entry : fs::directory_iterator(students[i].folder))
        files.push_back(entry.path());
      if (files.size() == 1 && !fs::is_symlink(files[0])) {
        fs::copy(files[0], to / (start + files[0].filename().string()));
        continue;
      }
      std::vector<MadeEntry> entries;
      for (const auto& entry : fs::directory_iterator(students[i].folder)) {
        if (entry.is_symlink()) {
          entries.push_back({entry.path().filename().string(), "", AE_IFLNK, "/etc/passwd"});
        } else {
          entries.push_back({entry.path().filename().string(), read_whole_file(entry.path())});
        }
      }
      make_archive(to / (start + "homework.zip"), entries);
    }
  }

  static std::string number(const GeneratedStudent& student) { return student.id.substr(7); }

  static void expect_layout(const std::string& layout,
                            std::string (*id)(const GeneratedStudent&)) {
    grade(place(layout), place(layout + "_results"), 2);
    EXPECT_THAT(read_whole_file(place(layout + "_results") / "class.json"),
                testing::HasSubstr("\"layout\": \"" + layout + "\""));
    expect_known_points(place(layout + "_results"), kStudentsOfALayout, id);
  }
};

TEST_F(ClassInLayout, Canvas) {
  arrange_files(place("canvas"), [](const GeneratedStudent& s) {
    return "lee" + s.id + "_" + number(s) + "_99" + number(s) + "_";
  });
  expect_layout("canvas", number);
}

TEST_F(ClassInLayout, Moodle) {
  arrange(place("moodle"), [](const GeneratedStudent& s) {
    return "Ann Lee_" + number(s) + "_assignsubmission_file";
  });
  expect_layout("moodle", number);
}

TEST_F(ClassInLayout, Gradescope) {
  std::string metadata;
  for (std::size_t i = 0; i < kStudentsOfALayout; ++i) {
    metadata += "submission_" + number(students[i]) + ":\n  :submitters:\n  - :name: N\n" +
                "    :sid: " + students[i].id + "\n    :email: e@x.edu\n";
  }
  arrange(place("gradescope"),
          [](const GeneratedStudent& s) { return "submission_" + number(s); });
  write_file(place("gradescope") / "submission_metadata.yml", metadata);
  expect_layout("gradescope", same_id);
}

TEST_F(ClassInLayout, GitHubClassroom) {
  arrange(place("github-classroom"),
          [](const GeneratedStudent& s) { return "flip-submissions/flip-" + s.id; });
  expect_layout("github-classroom", same_id);
}

TEST_F(ClassInLayout, Autolab) {
  arrange_files(place("autolab"), [](const GeneratedStudent& s) { return s.id + "@x.edu_3_"; });
  expect_layout("autolab", [](const GeneratedStudent& s) { return s.id + "@x.edu"; });
}

TEST_F(ClassInLayout, Nbgrader) {
  arrange(place("nbgrader"),
          [](const GeneratedStudent& s) { return "submitted/" + s.id + "/flip"; });
  expect_layout("nbgrader", same_id);
}

TEST_F(ClassInLayout, PlainArchive) {
  std::vector<MadeEntry> entries;
  for (std::size_t i = 0; i < kStudentsOfALayout; ++i) {
    entries.push_back({"class/" + students[i].id, "", AE_IFDIR});
    for (const auto& entry : fs::directory_iterator(students[i].folder)) {
      const std::string name =
          "class/" + students[i].id + "/" + entry.path().filename().string();
      if (!entry.is_symlink()) entries.push_back({name, read_whole_file(entry.path())});
    }
  }
  make_archive(place("class.tar.gz"), entries);
  grade(place("class.tar.gz"), place("archive_results"), 2);
  expect_known_points(place("archive_results"), kStudentsOfALayout, same_id);
}

}  // namespace
}  // namespace meshgrade
