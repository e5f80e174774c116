// Proves the grader with submissions that are known to be right or wrong. Every folder in
// tests/submissions is a test: its files take the place of those of the reference, and the
// report must say what the folder's expected.toml says (see expectation.h).

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <ostream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "grader/commands/context.h"
#include "grader/grade/grading.h"
#include "grader/judge/judge.h"
#include "grader/report/json_report.h"
#include "grader/report/terminal_report.h"
#include "tests/grade/expectation.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = MESHGRADE_SOURCE_DIR;
const fs::path kSubmissions = kSource / "tests" / "submissions";

/// A folder as GoogleTest's parameter: it prints as its name.
struct Folder {
  fs::path path;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(const Folder& folder, std::ostream* out) {
  *out << folder.path.lexically_relative(kSubmissions).string();
}

std::vector<Folder> folders_in(const fs::path& parent) {
  std::vector<Folder> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent)) {
    if (entry.is_directory()) folders.push_back({entry.path()});
  }
  std::sort(folders.begin(), folders.end(),
            [](const Folder& a, const Folder& b) { return a.path < b.path; });
  return folders;
}

std::vector<Folder> wrong_submissions() {
  std::vector<Folder> all;
  for (const Folder& exercise : folders_in(kSubmissions / "wrong")) {
    for (Folder& folder : folders_in(exercise.path))
      all.push_back(std::move(folder));
  }
  return all;
}

/// The name of the test: "edge_flip_next_wrong".
std::string test_name(const testing::TestParamInfo<Folder>& info) {
  const fs::path& path = info.param.path;
  const std::string parent = path.parent_path().filename().string();
  const std::string name = path.filename().string();
  return parent == "right" ? name : parent + "_" + name;
}

void put(std::vector<SourceFile>& files, const SourceFile& file) {
  const auto same_name = [&](const SourceFile& other) { return other.name == file.name; };
  const auto found = std::find_if(files.begin(), files.end(), same_name);
  if (found == files.end()) {
    files.push_back(file);
  } else {
    *found = file;
  }
}

/// The files of the folder, with those of the reference for what it does not hold.
Submission submission_in(const fs::path& folder, bool alone, const SubmissionRules& rules) {
  const Submission own = find_submission(folder, rules);
  if (alone) return own;
  Submission whole = find_submission(kSource / "reference", rules);
  whole.name = own.name;
  whole.headers = own.headers;
  for (const SourceFile& source : own.sources)
    put(whole.sources, source);
  return whole;
}

/// Leaves out what these exercises do not use, to be quick. All but the Bezier ones and the
/// normal may flip and split edges.
void drop_other_files(Submission& submission, const std::vector<std::string>& exercises) {
  const auto is_used = [&](const SourceFile& file) {
    return file.name.rfind("edge_", 0) == 0 ||
           std::find(exercises.begin(), exercises.end(), fs::path(file.name).stem().string()) !=
               exercises.end();
  };
  auto& files = submission.sources;
  files.erase(std::remove_if(files.begin(), files.end(), std::not_fn(is_used)), files.end());
}

Report grade_folder(const fs::path& folder, const Expectation& expected,
                    const std::vector<std::string>& exercises, const Home& home = find_home()) {
  Assignment assignment = read_assignment(standard_assignment());
  for (const auto& [limit, value] : expected.limits)
    assignment.limits.*limit = value;
  for (ExerciseRubric& rubric : assignment.exercises) {
    if (rubric.name != folder.parent_path().filename()) continue;
    for (const auto& [option, value] : expected.options)
      rubric.options.at(option).value = value;
  }
  Submission submission = submission_in(folder, expected.alone, assignment.submission);
  if (!exercises.empty()) drop_other_files(submission, exercises);
  return grade(assignment, submission, home, exercises, [](const std::string&) {});
}

/// What a student reads about one exercise.
std::string page_on(const ExerciseReport& exercise, Report report) {
  report.exercises = {exercise};
  return to_terminal(report, {});
}

/// The misconceptions that any finding about the exercise names.
std::set<std::string> named_in(const ExerciseReport& exercise) {
  std::set<std::string> names;
  for (const CaseReport& c : exercise.cases) {
    for (const FindingReport& report : c.findings) {
      for (const Misconception& m : report.finding.likely)
        names.insert(m.name);
    }
  }
  return names;
}

/// The name on the page's first line "rule"; empty if there is none.
std::string first_rule(const std::string& page) {
  const std::string label = "\n    rule      ";
  const std::size_t start = page.find(label);
  if (start == std::string::npos) return {};
  const std::size_t name = start + label.size();
  return page.substr(name, page.find_first_of(":\n", name) - name);
}

class WrongSubmission : public testing::TestWithParam<Folder> {
 protected:
  std::string exercise_ = GetParam().path.parent_path().filename().string();

  void judge(const ExerciseReport& exercise, const Expectation& expected,
             const std::string& page) const {
    EXPECT_EQ(verdict_name(exercise.verdict), expected.verdict);
    EXPECT_EQ(first_rule(page), expected.rule);
    ASSERT_TRUE(expected.points) << "expected.toml must say how many points are given";
    EXPECT_GE(exercise.points, *expected.points);
    EXPECT_LE(exercise.points, expected.most_points.value_or(*expected.points));
    EXPECT_EQ(exercise.extra_points, expected.extra_points.value_or(exercise.extra_points));
    for (const std::string& text : expected.says)
      EXPECT_NE(page.find(text), std::string::npos) << "the page does not say: " << text;
    EXPECT_EQ(named_in(exercise), expected.probably);
  }
};

TEST_P(WrongSubmission, IsFoundOut) {
  const Expectation expected = read_expectation(GetParam().path);
  std::vector<std::string> exercises{exercise_};
  for (const auto& [other, verdict] : expected.others)
    exercises.push_back(other);
  const Report report = grade_folder(GetParam().path, expected, exercises);
  for (const ExerciseReport& exercise : report.exercises) {
    const std::string page = page_on(exercise, report);
    SCOPED_TRACE(page);
    if (exercise.name == exercise_) {
      judge(exercise, expected, page);
    } else {
      EXPECT_EQ(verdict_name(exercise.verdict), expected.others.at(exercise.name));
    }
  }
}

/// A misconception that no submission triggers may be predicted wrongly, and one that comes
/// only with others may be mistaken for them.
TEST(Misconceptions, EachHasASubmissionThatTriggersExactlyIt) {
  const Assignment assignment = read_assignment(standard_assignment());
  for (const ExerciseRubric& rubric : assignment.exercises) {
    std::set<std::string> known;
    for (const Misconception& m : find_exercise_judge(rubric).misconceptions)
      EXPECT_TRUE(known.insert(m.name).second) << rubric.name << " has " << m.name << " twice";
    std::set<std::string> triggered;
    for (const Folder& folder : folders_in(kSubmissions / "wrong" / rubric.name)) {
      const std::set<std::string> named = read_expectation(folder.path).probably;
      if (named.size() == 1) triggered.insert(*named.begin());
    }
    EXPECT_EQ(triggered, known) << rubric.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Submissions, WrongSubmission, testing::ValuesIn(wrong_submissions()),
                         test_name);

class RightSubmission : public testing::TestWithParam<Folder> {};

TEST_P(RightSubmission, GetsFullPoints) {
  const Expectation expected = read_expectation(GetParam().path);
  const Report report = grade_folder(GetParam().path, expected, {});
  const std::string page = to_terminal(report, {});
  SCOPED_TRACE(page);
  EXPECT_EQ(report.points, report.max_points);
  for (const ExerciseReport& exercise : report.exercises)
    EXPECT_EQ(named_in(exercise), std::set<std::string>()) << exercise.name;
  EXPECT_EQ(report.extra_points, expected.extra_points.value_or(report.max_extra_points));
  const std::string everything = to_terminal(report, {false, true});
  for (const std::string& text : expected.says)
    EXPECT_NE(everything.find(text), std::string::npos) << "the report does not say: " << text;
}

INSTANTIATE_TEST_SUITE_P(Submissions, RightSubmission,
                         testing::ValuesIn(folders_in(kSubmissions / "right")), test_name);

/// Every 20th submission: all of them take some ten minutes.
std::vector<Folder> some_submissions() {
  std::vector<Folder> all = wrong_submissions();
  for (const Folder& folder : folders_in(kSubmissions / "right"))
    all.push_back(folder);
  const char* every = std::getenv("MESHGRADE_TEST_EVERY");
  const std::size_t step = every == nullptr ? 20 : std::strtoul(every, nullptr, 10);
  std::vector<Folder> some;
  for (std::size_t i = 0; i < all.size(); i += std::max<std::size_t>(step, 1))
    some.push_back(all[i]);
  return some;
}

/// The report without how much was printed before the clock stopped it: never the same twice.
std::string comparable(const Report& report) {
  static const std::regex printed("\"output_bytes\": [0-9]+");
  return std::regex_replace(to_json(report), printed, "");
}

class FilesCompiledAsOne : public testing::TestWithParam<Folder> {};

TEST_P(FilesCompiledAsOne, GiveTheSameReport) {
  const fs::path& folder = GetParam().path;
  const Expectation expected = read_expectation(folder);
  const std::string parent = folder.parent_path().filename().string();
  std::vector<std::string> exercises;
  if (parent != "right") exercises = {parent};
  Home home = find_home();
  const std::string together = comparable(grade_folder(folder, expected, exercises, home));
  home.joins_files = false;
  EXPECT_EQ(comparable(grade_folder(folder, expected, exercises, home)), together);
}

INSTANTIATE_TEST_SUITE_P(Submissions, FilesCompiledAsOne, testing::ValuesIn(some_submissions()),
                         test_name);

}  // namespace
}  // namespace meshgrade
