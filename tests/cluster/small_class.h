#pragma once

// A class that is graded quickly: everybody hands in the curve of the reference, and one
// nothing.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "grader/base/process.h"
#include "grader/base/safe_file.h"

namespace meshgrade {

class SmallClass : public testing::Test {
 protected:
  /// `pause_ms` is how long each step of the curve takes.
  void hand_in(std::size_t count, int pause_ms = 0) const {
    std::string curve = read_whole_file(std::filesystem::path(MESHGRADE_SOURCE_DIR) /
                                        "reference" / "bezier_curve.cpp");
    const std::size_t body = curve.find('{', curve.find("BezierCurve::evaluateStep(const")) + 1;
    curve.insert(body, " usleep(" + std::to_string(1000 * pause_ms) + ");");
    for (std::size_t i = 0; i < count; ++i) {
      const std::filesystem::path folder = class_ / ("student" + std::to_string(100 + i));
      std::filesystem::create_directories(folder);
      write_file_safely(folder / "bezier_curve.cpp",
                        "#include <unistd.h>\n" + curve + "// " + std::to_string(i) + "\n");
    }
    std::filesystem::create_directories(class_ / "empty");
  }

  std::vector<std::string> batch_command(std::vector<std::string> more) const {
    std::vector<std::string> words{MESHGRADE_PROGRAM, "batch",      class_.string(), "-o",
                                   results_.string(), "--exercise", "bezier_curve"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  static ProcessResult run(std::vector<std::string> words) {
    Command command;
    command.arguments = std::move(words);
    command.time_limit = std::chrono::minutes(4);
    return run_process(command);
  }

  std::string grades() const { return read_whole_file(results_ / "grades.csv"); }

  /// What the class gets when it is graded here.
  std::string grades_without_cluster() {
    results_ = scratch_.path() / "here";
    EXPECT_EQ(run(batch_command({})).status, 1) << "one hand-in is empty";
    return grades();
  }

  ScratchFolder scratch_;
  std::filesystem::path class_ = scratch_.path() / "class";
  std::filesystem::path results_ = scratch_.path() / "results";
};

}  // namespace meshgrade
