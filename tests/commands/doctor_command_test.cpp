// What the commands tell about the sandbox.

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "grader/sandbox/sandbox.h"
#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;

class DoctorCommand : public CommandLine {};

TEST_F(DoctorCommand, EveryLayerIsListedWithWhatItPromises) {
  const Said said = call({"doctor"});
  EXPECT_EQ(said.status, 0);
  for (const Layer layer : {Layer::kNamespaces, Layer::kOtherUser, Layer::kSameUser}) {
    EXPECT_THAT(said.output, HasSubstr("layer " + layer_name(layer)));
    EXPECT_THAT(said.output, HasSubstr(layer_promise(layer)));
  }
  for (const char* name :
       {"Landlock", "seccomp", "bubblewrap", "other user", "graded in layer"})
    EXPECT_THAT(said.output, HasSubstr(name));
}

TEST_F(DoctorCommand, WithoutBubblewrapItIsNamedAsMissing) {
  const std::string path = std::getenv("PATH");
  // A folder with all programs but bwrap would be long: none has to be found for this.
  ::setenv("PATH", "/nowhere", 1);
  const Said said = call({"doctor"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(said.status, 0) << said.output;
  EXPECT_THAT(said.output, HasSubstr("bubblewrap: not installed"));
}

/// As a container would: namespaces are refused.
TEST_F(DoctorCommand, CheckSaysItsSandboxAndRefusesWeakOnes) {
  Command command;
  // A sanitizer's search for leaks needs calls that the filter denies.
  command.arguments = {"env",
                       "ASAN_OPTIONS=detect_leaks=0",
                       MESHGRADE_KIT_DIR "/meshgrade-launcher",
                       "--calls",
                       "few",
                       "--",
                       MESHGRADE_PROGRAM,
                       "check",
                       reference(),
                       "vertex_normal",
                       "-v",
                       "--require-sandbox"};
  command.time_limit = std::chrono::minutes(4);
  const ProcessResult result = run_process(command);
  if (result.status == 125) GTEST_SKIP() << result.output;  // a kernel without seccomp
  if (::geteuid() == 0) {
    EXPECT_EQ(result.status, 0) << result.output;
    EXPECT_THAT(result.output, HasSubstr("sandbox: " + layer_name(Layer::kOtherUser)));
  } else {
    EXPECT_EQ(result.status, 2) << result.output;
    EXPECT_THAT(result.output, HasSubstr("meshgrade doctor"));
  }
}

}  // namespace
}  // namespace meshgrade
