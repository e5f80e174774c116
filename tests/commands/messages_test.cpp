// What the program says of a wrong call, and how it ends then.

#include <algorithm>

#include "grader/base/safe_file.h"
#include "tests/commands/command_line.h"
#include "tests/support/scratch_files.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Messages : public CommandLine {
 protected:
  /// Calls the program in a shell, as "$0".
  static Said call_in_shell(const std::string& script) {
    Command command;
    command.arguments = {"bash", "-c", script, MESHGRADE_PROGRAM};
    const ProcessResult result = run_process(command);
    return {result.status, result.output};
  }

  static std::string mesh(const std::string& name) {
    return MESHGRADE_SOURCE_DIR "/meshes/" + name;
  }
};

TEST_F(Messages, AMistypedCommandIsNamed) {
  const Said said = call({"nonsense", "--json", "x"});
  EXPECT_EQ(said.status, 2);
  EXPECT_EQ(said.output, "meshgrade: there is no command \"nonsense\"; see --help\n");
}

// Also where only another exercise is asked for.
TEST_F(Messages, AWrongOptionOfAnAssignmentIsRefusedWithItsLine) {
  const fs::path file = folder_ / "a.toml";
  std::string text = read_whole_file(MESHGRADE_SOURCE_DIR "/grader/assignment.toml");
  const std::size_t at = text.find("vertex_rule");
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  text.replace(at, 11, "vertx_rule");
  write_file_safely(file, text);
  const Said said = call({"check", MESHGRADE_SOURCE_DIR "/reference", "bezier_curve",
                          "--assignment", file.string()});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output,
              StartsWith("meshgrade: " + file.string() + ":" + std::to_string(line) +
                         ": loop_subdivision has no option"));
}

TEST_F(Messages, LostOutputIsNoSuccess) {
  for (const std::string& arguments :
       {"mesh-info '" + mesh("cube.obj") + "'", std::string("hint edge_flip --all"),
        std::string("--help"), "autograde '" + folder_.string() + "' --write gradescope=-"}) {
    const Said said = call_in_shell("\"$0\" " + arguments + " >/dev/full");
    EXPECT_EQ(said.status, 2) << arguments;
    EXPECT_THAT(said.output,
                HasSubstr("meshgrade: standard output cannot be written: No space"))
        << arguments;
  }
}

TEST_F(Messages, StandardOutputThatGoesToAFileIsNotReplaced) {
  const fs::path file = folder_ / "both.txt";
  call_in_shell("\"$0\" check '" MESHGRADE_SOURCE_DIR
                "/reference' bezier_curve --color never --json /dev/stdout > '" +
                file.string() + "'");
  EXPECT_THAT(read_whole_file(file),
              AllOf(StartsWith("Half-edge meshes"), HasSubstr("\"exercises\"")));
}

TEST_F(Messages, WhoHasSeenEnoughIsNotTold) {
  const Said said =
      call_in_shell("trap '' PIPE; \"$0\" hint edge_flip --all | true; echo ${PIPESTATUS[0]}");
  EXPECT_EQ(said.output, "0\n");
}

TEST_F(Messages, NamesOfFilesDoNotRuleTheTerminal) {
  const Said said = call({"mesh-info", "\x1B[31mé.obj"});
  EXPECT_EQ(said.status, 2);
  EXPECT_EQ(said.output, "meshgrade: ?[31mé.obj: no such file; check the path\n");
  EXPECT_THAT(call({"check", ".", "--\x1B[31m"}).output, Not(HasSubstr("\x1B")));
}

TEST_F(Messages, WhatIsNoFolderIsNotSaidToBeMissing) {
  write("hw.cpp", "int x;\n");
  const Said said =
      call({"batch", (folder_ / "hw.cpp").string(), "-o", (scratch_.path() / "r").string()});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("hw.cpp: is neither a folder nor an archive"));
}

TEST_F(Messages, ASubmissionThatIsNotThereHasNoProgressAndNoHints) {
  const std::string missing = (folder_ / "nothere").string();
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"list", missing}, {"hint", "edge_flip", missing}}) {
    const Said said = call(arguments);
    EXPECT_EQ(said.status, 2);
    EXPECT_EQ(said.output, "meshgrade: " + missing + ": there is no such file or folder\n");
  }
}

TEST_F(Messages, AMeshThatIsNoSurfaceIsNamed) {
  const std::string file = mesh("invalid/bow_tie.obj");
  const Said said = call({"view", file, "--submission", reference(), "--screenshot",
                          (scratch_.path() / "a.svg").string()});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, StartsWith("meshgrade: " + file + ": "));
}

}  // namespace
}  // namespace meshgrade
