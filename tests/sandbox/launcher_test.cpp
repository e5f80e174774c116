// The launcher itself, and which layer is taken where the kernel refuses namespaces.

#include <gtest/gtest.h>
#include <unistd.h>

#include "grader/base/process.h"
#include "grader/sandbox/sandbox.h"

namespace meshgrade {
namespace {

constexpr const char* kLauncher = MESHGRADE_KIT_DIR "/meshgrade-launcher";

ProcessResult launch(std::vector<std::string> words) {
  Command command;
  command.arguments = {kLauncher};
  command.arguments.insert(command.arguments.end(), words.begin(), words.end());
  return run_process(command);
}

TEST(Launcher, WrongOptionsStartNothing) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--no-such-option", "1", "--", "echo", "started"},
                                             {"--cpu", "-1", "--", "echo", "started"},
                                             {"--cpu", "many", "--", "echo", "started"},
                                             {"--calls", "all", "--", "echo", "started"},
                                             {"--cpu", "1"},
                                             {}}) {
    const ProcessResult result = launch(words);
    EXPECT_EQ(result.status, 125);
    EXPECT_EQ(result.output.find("started\n"), std::string::npos) << result.output;
  }
}

TEST(Launcher, MissingProgramIsToldByName) {
  const ProcessResult result = launch({"--", "no-such-program"});
  EXPECT_EQ(result.status, 125);
  EXPECT_NE(result.output.find("no-such-program"), std::string::npos);
}

TEST(Launcher, SupervisorEndsLikeTheProgram) {
  EXPECT_EQ(launch({"--supervise", "yes", "--", "sh", "-c", "exit 7"}).status, 7);
  EXPECT_EQ(launch({"--supervise", "yes", "--", "sh", "-c", "kill -TERM $$"}).signal, 15);
}

/// A container: system calls for namespaces fail, and there is no way back.
TEST(Launcher, WithoutNamespacesTheNextLayerIsTaken) {
  const Sandbox here = find_sandbox(MESHGRADE_KIT_DIR, MESHGRADE_COMPILER);
  if (!here.filters_calls) GTEST_SKIP() << "this kernel has no seccomp to refuse namespaces by";
  // The leak check of the address sanitizer needs a call that is refused.
  const ProcessResult result =
      launch({"--calls", "few", "--", "env", "ASAN_OPTIONS=detect_leaks=0", MESHGRADE_PROGRAM,
              "doctor"});
  EXPECT_EQ(result.status, 0) << result.output;
  const Layer next = ::geteuid() == 0 ? Layer::kOtherUser : Layer::kSameUser;
  EXPECT_NE(result.output.find("graded in layer " + layer_name(next)), std::string::npos)
      << result.output;
  EXPECT_NE(result.output.find("missing  layer 1"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace meshgrade
