#include "grader/assignment/assignment.h"

#include <gtest/gtest.h>

#include "tests/support/scratch_files.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

const char* const kLeast =
    "version = 1\n"
    "title = \"T\"\n"
    "seed = 7\n"
    "[[exercise]]\n"
    "name = \"edge_flip\"\n"
    "[[exercise.group]]\n"
    "name = \"basic\"\n"
    "points = 3\n";

TEST(Assignment, StandardOneAddsUpToAHundredAndTen) {
  const Assignment assignment = read_assignment(MESHGRADE_SOURCE_DIR "/grader/assignment.toml");
  EXPECT_EQ(assignment.points(), 100.0);
  double extra = 0.0;
  for (const ExerciseRubric& exercise : assignment.exercises)
    extra += exercise.extra_points();
  EXPECT_EQ(extra, 10.0);
  EXPECT_EQ(assignment.exercises.size(), 6U);
  EXPECT_NE(assignment.find("edge_split"), nullptr);
  EXPECT_EQ(assignment.find("edge_collapse"), nullptr);
}

std::string with_hidden(const std::string& keys) {
  std::string text = kLeast;
  return text.insert(text.find("[[exercise]]"), "[hidden]\n" + keys);
}

TEST(Assignment, HiddenSeedIsReadWhereItsFileIs) {
  const ScratchFolder folder;
  const auto file = write_file(folder.path() / "a.toml",
                               with_hidden("seed_file = \"secret\"\nshow = \"rule\"\n"));
  EXPECT_FALSE(read_assignment(file).hidden->seed);
  write_file(folder.path() / "secret", "4711\n");
  EXPECT_EQ(read_assignment(file).hidden->seed, 4711U);
  EXPECT_EQ(read_assignment(file).hidden->show, HiddenShow::kRule);
  write_file(folder.path() / "secret", "about 7");
  EXPECT_EQ(user_error([&] { read_assignment(file); }),
            (folder.path() / "secret").string() +
                ": must hold one whole number, the seed of the hidden cases");
}

TEST(Assignment, HiddenMistakesAreNamed) {
  EXPECT_EQ(user_error([] { parse_assignment(with_hidden(""), "a.toml"); }),
            "a.toml:4: the key hidden.seed_file is missing");
  EXPECT_EQ(user_error([] {
              parse_assignment(with_hidden("seed_file = \"s\"\nshow = \"much\"\n"), "a.toml");
            }),
            "a.toml:6: hidden.show must be \"name\", \"rule\" or \"all\"");
}

TEST(Assignment, LeastOneHasTheStandardValues) {
  const Assignment a = parse_assignment(kLeast, "a.toml");
  EXPECT_EQ(a.seed, 7U);
  EXPECT_EQ(a.tolerance, 1e-5);
  EXPECT_EQ(a.limits.case_cpu_ms, Limits{}.case_cpu_ms);
  EXPECT_TRUE(a.submission.headers);
  const Group& group = a.exercises.at(0).groups.at(0);
  EXPECT_EQ(group.title, "basic");
  EXPECT_FALSE(group.extra_credit);
  EXPECT_EQ(group.partial, Partial::kNone);
  EXPECT_EQ(a.points(), 3.0);
}

TEST(Assignment, EveryKeyIsRead) {
  const Assignment a = parse_assignment(
      "version = 1\ntitle = \"T\"\nseed = 0\ntolerance = 1e-4\n"
      "[limits]\ncompile_seconds = 1\ncase_cpu_ms = 2\ncase_wall_ms = 3\nrun_seconds = 4\n"
      "memory_mb = 5\nresult_mb = 6\n"
      "[submission]\nheaders = false\nfiles = 7\nfile_kb = 8\n"
      "[[exercise]]\nname = \"a\"\ntitle = \"A\"\n[exercise.options]\nx = \"y\"\n"
      "[[exercise.group]]\nname = \"g\"\npoints = 0.5\npartial = \"cases\"\n"
      "[[exercise.group]]\nname = \"h\"\npoints = 2\nextra_credit = true\nneeds = \"g\"\n"
      "[[exercise]]\nname = \"b\"\nneeds = [\"a\"]\n"
      "[[exercise.group]]\nname = \"g\"\npoints = 1\n",
      "a.toml");
  EXPECT_EQ(a.tolerance, 1e-4);
  EXPECT_EQ(a.limits.compile_seconds, 1U);
  EXPECT_EQ(a.limits.case_cpu_ms, 2U);
  EXPECT_EQ(a.limits.case_wall_ms, 3U);
  EXPECT_EQ(a.limits.run_seconds, 4U);
  EXPECT_EQ(a.limits.memory_mb, 5U);
  EXPECT_EQ(a.limits.result_mb, 6U);
  EXPECT_FALSE(a.submission.headers);
  EXPECT_EQ(a.submission.files, 7U);
  EXPECT_EQ(a.submission.file_kb, 8U);
  const ExerciseRubric& first = a.exercises[0];
  EXPECT_EQ(first.title, "A");
  EXPECT_EQ(first.options.at("x").value, "y");
  EXPECT_EQ(first.groups[0].partial, Partial::kCases);
  EXPECT_TRUE(first.groups[1].extra_credit);
  EXPECT_EQ(first.groups[1].needs, "g");
  EXPECT_EQ(first.points(), 0.5);
  EXPECT_EQ(first.extra_points(), 2.0);
  EXPECT_EQ(a.exercises[1].needs, (std::vector<std::string>{"a"}));
}

/// A change of one line of the least assignment, and what is said about it.
struct Mistake {
  const char* line;  ///< to be replaced; empty: the new text goes to the end
  const char* by;
  const char* place;
  const char* word;
};

std::string with_mistake(const Mistake& mistake) {
  std::string text = kLeast;
  const std::string line = mistake.line;
  if (line.empty()) return text + mistake.by + "\n";
  return text.replace(text.find(line), line.size(), mistake.by);
}

TEST(Assignment, EveryMistakeIsOneLineWithPlaceAndKey) {
  const Mistake mistakes[] = {
      {"version = 1", "", "a.toml:", "version"},
      {"version = 1", "version = 2", "a.toml:1:", "version"},
      {"version = 1", "version = \"1\"", "a.toml:1:", "version"},
      {"version = 1", "version = 1.0", "a.toml:1:", "version"},
      {"title = \"T\"", "", "a.toml:", "title"},
      {"title = \"T\"", "title = 3", "a.toml:2:", "title"},
      {"seed = 7", "seed = -1", "a.toml:3:", "seed"},
      {"seed = 7", "seed = 1.5", "a.toml:3:", "seed"},
      {"seed = 7", "seed = 99999999999999999999", "a.toml:3:", ""},
      {"seed = 7", "seed = 7\ntolerance = 0", "a.toml:4:", "tolerance"},
      {"seed = 7", "seed = 7\ntolerance = 0.5", "a.toml:4:", "tolerance"},
      {"seed = 7", "seed = 7\ntolerance = nan", "a.toml:4:", "tolerance"},
      {"seed = 7", "seed = 7\ntolerance = true", "a.toml:4:", "tolerance"},
      {"seed = 7", "seed = 7\nseed = 8", "a.toml:4:", "seed"},
      {"seed = 7", "seed = 7\nsead = 8", "a.toml:4:", "sead"},
      {"seed = 7", "seed = 7\nlimits = 8", "a.toml:4:", "limits"},
      {"seed = 7", "seed = ", "a.toml:3:", ""},
      {"name = \"edge_flip\"", "", "a.toml:4:", "exercise.name"},
      {"name = \"edge_flip\"", "name = \"edge_flip\"\nneeds = \"x\"", "a.toml:6:", "needs"},
      {"name = \"edge_flip\"", "name = \"edge_flip\"\nneeds = [\"x\"]", "a.toml:6:", "needs"},
      {"name = \"edge_flip\"", "name = \"edge_flip\"\nneeds = [\"edge_flip\"]",
       "a.toml:6:", "needs"},
      {"name = \"edge_flip\"", "name = \"edge_flip\"\noptions = 1", "a.toml:6:", "options"},
      {"name = \"edge_flip\"", "name = \"edge_flip\"\noptions = {a = 1}",
       "a.toml:6:", "options.a"},
      {"name = \"edge_flip\"", "name = \"edge_flip\"\npoints = 3", "a.toml:6:", "points"},
      {"points = 3", "", "a.toml:6:", "points"},
      {"points = 3", "points = \"3\"", "a.toml:8:", "points"},
      {"points = 3", "points = -1", "a.toml:8:", "points"},
      {"points = 3", "points = nan", "a.toml:8:", "points"},
      {"points = 3", "points = inf", "a.toml:8:", "points"},
      {"points = 3", "points = true", "a.toml:8:", "points"},
      {"", "partial = 1", "a.toml:9:", "\"none\", \"cases\", \"pointers\""},
      {"", "partial = \"most\"", "a.toml:9:", "\"none\", \"cases\", \"pointers\""},
      {"", "extra_credit = \"yes\"", "a.toml:9:", "extra_credit"},
      {"", "needs = \"later\"", "a.toml:9:", "needs"},
      {"", "needs = \"basic\"", "a.toml:9:", "needs"},
      {"", "nedes = \"basic\"", "a.toml:9:", "nedes"},
      {"", "[[exercise.group]]\nname = \"basic\"\npoints = 1", "a.toml:10:", "basic"},
      {"", "[[exercise]]\nname = \"edge_flip\"\n[[exercise.group]]\nname = \"b\"\npoints = 1",
       "a.toml:10:", "edge_flip"},
      {"", "[[exercise]]\nname = \"b\"", "a.toml:9:", "exercise.group"},
      {"", "[limits]\ncase_cpu_ms = 0", "a.toml:10:", "limits.case_cpu_ms"},
      {"", "[limits]\ncase_cpu_ms = 99999999999", "a.toml:10:", "limits.case_cpu_ms"},
      {"", "[limits]\ncase_cpu_ms = 2.5", "a.toml:10:", "limits.case_cpu_ms"},
      {"", "[limits]\ncpu = 5", "a.toml:10:", "limits.cpu"},
      {"", "[submission]\nheaders = 1", "a.toml:10:", "submission.headers"},
      {"", "[submission]\nfiles = -2", "a.toml:10:", "submission.files"},
      {"", "[submission]\nsize = 2", "a.toml:10:", "submission.size"},
  };
  for (const Mistake& mistake : mistakes) {
    const std::string message =
        user_error([&] { parse_assignment(with_mistake(mistake), "a.toml"); });
    EXPECT_EQ(message.rfind(mistake.place, 0), 0U) << mistake.by << "\n" << message;
    EXPECT_NE(message.find(mistake.word), std::string::npos) << mistake.by << "\n" << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(Assignment, ExercisesAreNeeded) {
  const std::string message =
      user_error([] { parse_assignment("version = 1\ntitle = \"T\"\nseed = 1\n", "a.toml"); });
  EXPECT_NE(message.find("[[exercise]]"), std::string::npos);
}

TEST(Assignment, FileThatCannotBeReadIsNamed) {
  const ScratchFolder folder;
  const auto message = [](const std::filesystem::path& file) {
    return user_error([&] { read_assignment(file); });
  };
  EXPECT_NE(message(folder.path() / "none.toml").find("none.toml"), std::string::npos);
  EXPECT_NE(message(folder.path()).find(folder.path().string()), std::string::npos);
  const auto file = write_file(folder.path() / "bad.toml", "version = \xFF\n");
  EXPECT_NE(message(file).find("bad.toml:1"), std::string::npos);
}

}  // namespace
}  // namespace meshgrade
