// What a command is to write is checked before it works: nothing that it reads is overwritten,
// and nothing is lost because it cannot be written in the end.

#include "grader/commands/output_check.h"

#include <sys/stat.h>

#include "grader/base/safe_file.h"
#include "tests/commands/command_line.h"
#include "tests/support/scratch_files.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

namespace fs = std::filesystem;

class OutputCheck : public CommandLine {
 protected:
  /// What is said about outputs behind --a, --b, ...
  static std::string refusal(const std::vector<fs::path>& files,
                             const std::vector<fs::path>& inputs = {}) {
    std::vector<Output> outputs;
    for (const fs::path& file : files)
      outputs.push_back({std::string("--") + static_cast<char>('a' + outputs.size()), file});
    return user_error([&] { check_outputs(outputs, inputs); });
  }

  fs::path file(const std::string& name, const std::string& text = "text") const {
    return write_file(scratch_.path() / name, text);
  }

  fs::path in_ = file("in.obj");
  fs::path out_ = scratch_.path() / "out.obj";
};

TEST_F(OutputCheck, OtherFilesMayBeWrittenAndReplaced) {
  EXPECT_EQ(refusal({out_, scratch_.path() / "b"}, {in_}), "");
  EXPECT_EQ(refusal({file("old")}, {in_, "", scratch_.path() / "nothing"}), "");
  EXPECT_EQ(refusal({"just_a_name"}), "") << "in the current folder";
}

TEST_F(OutputCheck, AnInputIsRefusedByAnyOfItsNames) {
  fs::create_symlink(in_, scratch_.path() / "link");
  fs::create_directory(scratch_.path() / "sub");
  for (const fs::path& name :
       {in_, scratch_.path() / "sub" / ".." / "in.obj", scratch_.path() / "link"})
    EXPECT_EQ(refusal({out_, name}, {in_}),
              name.string() +
                  ": is an input, and would be overwritten; give another name behind --b");
}

TEST_F(OutputCheck, TwoOutputsAreTwoFilesAlsoBeforeTheyAreThere) {
  const fs::path same = scratch_.path() / "." / "out.obj";
  const std::string told = same.string() +
                           ": two outputs go to this file, behind --a and --b; give each a "
                           "file of its own";
  EXPECT_EQ(refusal({out_, same}), told);
  file("out.obj");
  EXPECT_EQ(refusal({out_, same}), told);
}

TEST_F(OutputCheck, APlaceWhereNoFileCanBeIsRefused) {
  EXPECT_EQ(refusal({scratch_.path()}),
            scratch_.path().string() + ": is a folder; name a file behind --a");
  const fs::path missing = scratch_.path() / "missing";
  EXPECT_EQ(refusal({missing / "a"}), (missing / "a").string() + ": there is no folder " +
                                          missing.string() + "; make it first");
}

TEST_F(OutputCheck, StandardOutputPipesAndDevicesMayAlwaysBeWrittenTo) {
  const fs::path pipe = scratch_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(refusal({"-", "-", "/dev/stdout", "/dev/null", "/dev/null", pipe, pipe}, {pipe}),
            "");
}

TEST_F(OutputCheck, CheckKeepsTheSubmissionAndTheAssignment) {
  const fs::path source = file("hw/edge_flip.cpp", "int x;\n");
  const fs::path toml =
      file("a.toml", read_whole_file(MESHGRADE_SOURCE_DIR "/grader/assignment.toml"));
  const std::string hw = (scratch_.path() / "hw").string();
  for (const char* option : {"--json", "--html"}) {
    for (const fs::path& input : {source, toml}) {
      const Said said =
          call({"check", hw, "--assignment", toml.string(), option, input.string()});
      EXPECT_EQ(said.status, 2);
      EXPECT_THAT(said.output, HasSubstr(std::string("is an input, and would be overwritten; "
                                                     "give another name behind ") +
                                         option));
    }
    EXPECT_EQ(call({"check", source.string(), option, source.string()}).status, 2);
    const Said nameless = call({"check", hw, option, ""});
    EXPECT_EQ(nameless.status, 2);
    EXPECT_THAT(nameless.output, HasSubstr("the name of the file is empty"));
  }
  const std::string out = (scratch_.path() / "out").string();
  EXPECT_THAT(call({"check", hw, "--json", out, "--html", out}).output,
              HasSubstr("two outputs go to this file, behind --json and --html"));
  EXPECT_EQ(read_whole_file(source), "int x;\n");
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(OutputCheck, AutogradeKeepsTheSubmissionAndItsResultsApart) {
  const fs::path source = file("hw/edge_flip.cpp", "int x;\n");
  const std::string hw = (scratch_.path() / "hw").string();
  EXPECT_THAT(call({"autograde", hw, "--write", "gradescope=" + source.string()}).output,
              HasSubstr("is an input"));
  const Said twice = call({"autograde", hw, "--write", "gradescope=" + out_.string(), "--write",
                           "markdown=" + out_.string()});
  EXPECT_EQ(twice.status, 2);
  EXPECT_THAT(twice.output, HasSubstr("behind --write gradescope and --write markdown"));
  EXPECT_EQ(read_whole_file(source), "int x;\n");
}

// Else a wrong path in a platform's script would give a whole class no points.
TEST_F(OutputCheck, AutogradeOfWhatIsNotThereWritesNoScore) {
  const std::string target = "gradescope=" + out_.string();
  const Said missing = call({"autograde", (folder_ / "typo").string(), "--write", target});
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.output, HasSubstr("there is no such file or folder to grade"));
  EXPECT_FALSE(fs::exists(out_));
  EXPECT_EQ(call({"autograde", folder_.string(), "--write", target}).status, 0);
  EXPECT_THAT(read_whole_file(out_), HasSubstr("\"score\": 0.0"))
      << "an empty folder was handed in";
}

TEST_F(OutputCheck, SubdivideKeepsItsInput) {
  const fs::path mesh = file("m.obj", read_whole_file(MESHGRADE_SOURCE_DIR "/meshes/cube.obj"));
  const Said said = call({"subdivide", mesh.string(), "-o", mesh.string()});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("is an input"));
}

TEST_F(OutputCheck, SimilarityWritesOverNobodysWork) {
  const fs::path source = file("class/ann/edge_flip.cpp");
  const std::string folder = (scratch_.path() / "class").string();
  const Said said = call({"similarity", folder, "-o", source.string()});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("is an input"));
  EXPECT_EQ(read_whole_file(source), "text");
}

TEST_F(OutputCheck, SimilarityNeedsNoOutput) {
  const std::string code = read_whole_file(MESHGRADE_SOURCE_DIR "/reference/edge_flip.cpp");
  for (const char* who : {"ann", "bob", "cem"})
    file(std::string("class/") + who + "/edge_flip.cpp", *who == 'c' ? "int x;" : code);
  const Said said = call({"similarity", (scratch_.path() / "class").string()});
  EXPECT_EQ(said.status, 0);
  EXPECT_THAT(said.output, HasSubstr("group of 2: ann, bob\n100 % of ann is in bob, 100 %"));
  EXPECT_THAT(said.output, HasSubstr("1 pair with something in common"));
}

TEST_F(OutputCheck, BundleKeepsTheAssignment) {
  const fs::path toml =
      file("a.zip", read_whole_file(MESHGRADE_SOURCE_DIR "/grader/assignment.toml"));
  const Said said =
      call({"bundle", "github", "-o", toml.string(), "--assignment", toml.string()});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("is an input"));
}

class Export : public OutputCheck {
 protected:
  Export() {
    file("class/bob/essay.txt");
    EXPECT_EQ(call({"batch", (scratch_.path() / "class").string(), "-o", results_}).status, 1);
  }

  Said run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"export", results_});
    return call(arguments);
  }

  std::string results_ = (scratch_.path() / "results").string();
};

TEST_F(Export, KeepsTheGradebookAndTheResults) {
  const fs::path book = file("book.csv", "Identifier,Name,Grade\nParticipant 1,Ann,\n");
  const Said said = run({"moodle", "--gradebook", book.string(), "-o", book.string()});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("is an input"));
  const std::string before = read_whole_file(results_ + "/class.json");
  EXPECT_EQ(run({"csv", "-o", results_ + "/class.json"}).status, 2);
  EXPECT_EQ(read_whole_file(results_ + "/class.json"), before);
}

TEST_F(Export, FullPointsAreANumberAboveNothing) {
  for (const char* worth : {"0", "-5", "nan", "inf"}) {
    const Said said = run({"canvas", std::string("--out-of=") + worth});
    EXPECT_EQ(said.status, 2) << worth;
    EXPECT_THAT(said.output, HasSubstr("full points must be worth more than 0"));
  }
  EXPECT_EQ(run({"canvas", "--out-of", "7.5"}).status, 0);
}

TEST_F(Export, AFormatRefusesWhatItCannotFollow) {
  const std::string book = file("book.csv").string();
  for (const char* format : {"csv", "gradescope", "junit"}) {
    for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{
             {"--out-of", "10"}, {"--column", "HW"}, {"--gradebook", book}}) {
      const Said said = run({format, option, value});
      EXPECT_EQ(said.status, 2) << format << option;
      EXPECT_THAT(said.output, EndsWith(std::string(format) + " takes no " + option +
                                        ": it is for canvas and moodle\n"));
    }
  }
}

}  // namespace
}  // namespace meshgrade
