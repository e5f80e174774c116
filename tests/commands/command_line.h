#pragma once

// Calls the program as a person would, with state and cache folders of the test's own.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "grader/base/process.h"

namespace meshgrade {

struct Said {
  int status = 0;
  std::string output;  ///< both stdout and stderr
};

class CommandLine : public testing::Test {
 protected:
  CommandLine() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = scratch_.path() / test->name();
    std::filesystem::create_directories(folder_);
    ::setenv("XDG_STATE_HOME", (scratch_.path() / "state").c_str(), 1);
    ::setenv("XDG_CACHE_HOME", (scratch_.path() / "cache").c_str(), 1);
    ::unsetenv("MESHGRADE_CALLED_AS");
  }

  static Said call(const std::vector<std::string>& arguments, const std::string& input = "") {
    Command command;
    command.arguments = {MESHGRADE_PROGRAM};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    command.input = input;
    command.time_limit = std::chrono::minutes(4);
    const ProcessResult result = run_process(command);
    return {result.signal != 0 ? -result.signal : result.status, result.output};
  }

  /// Calls the program and presses Ctrl-C once a shell command succeeds, for which "$0" is the
  /// file with what the program has said so far.
  Said call_and_interrupt(const std::string& once,
                          const std::vector<std::string>& arguments) const {
    Command command;
    const std::string script =
        "\"$@\" >\"$0\" 2>&1 & program=$!; "
        "for i in $(seq 2000); do " +
        once +
        " && break; sleep 0.1; done; "
        "kill -INT $program; wait $program; status=$?; cat \"$0\"; exit $status";
    command.arguments = {"bash", "-c", script, (scratch_.path() / "said").string(),
                         MESHGRADE_PROGRAM};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    command.time_limit = std::chrono::minutes(4);
    const ProcessResult result = run_process(command);
    return {result.status, result.output};
  }

  static std::string reference() { return MESHGRADE_SOURCE_DIR "/reference"; }
  /// One of the meshes that come along.
  static std::string given(const std::string& mesh) {
    return MESHGRADE_SOURCE_DIR "/meshes/" + mesh;
  }
  /// A file of this test's folder, to be written.
  std::string result(const std::string& name) const { return (folder_ / name).string(); }
  static std::string wrong(const std::string& name) {
    return MESHGRADE_SOURCE_DIR "/tests/submissions/wrong/" + name;
  }

  /// Writes a file of this test's submission.
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  ScratchFolder scratch_;
  std::filesystem::path folder_;  ///< this test's submission, empty at first
};

}  // namespace meshgrade
