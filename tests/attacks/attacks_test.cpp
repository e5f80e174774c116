// Every folder here is a hostile submission, graded on each layer that this machine can
// provide. The points stay what its mesh deserves; nothing of the instructor's is read, written
// or shown; nothing is left running or lying about. Its expected.toml says the rest.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "grader/commands/context.h"
#include "grader/grade/grading.h"
#include "grader/report/json_report.h"
#include "grader/report/terminal_report.h"
#include "tests/attacks/attack_expectation.h"
#include "tests/attacks/traces.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

const fs::path kAttacks = fs::path(MESHGRADE_SOURCE_DIR) / "tests" / "attacks";

std::vector<std::string> attack_names() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(kAttacks)) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Limits quick_limits() {
  Limits limits;
  limits.compile_seconds = 30;
  limits.case_cpu_ms = 300;
  limits.case_wall_ms = 1000;
  limits.run_seconds = 8;
  limits.memory_mb = 256;
  limits.result_mb = 16;
  limits.output_mb = 1;
  limits.processes = 16;
  return limits;
}

int landlock_version(const Sandbox& sandbox) {
  for (const Probe& probe : sandbox.probes) {
    if (probe.name == "Landlock" && probe.works) {
      return std::atoi(probe.detail.c_str() + std::string("version ").size());
    }
  }
  return 0;
}

/// Why this attack cannot be tried in this sandbox; empty if it can.
std::string obstacle(const Sandbox& sandbox, Layer layer, const AttackExpectation& expected) {
  if (sandbox.layer != layer) {
    for (const Probe& probe : sandbox.probes) {
      if (probe.name == "layer " + layer_name(layer)) return probe.detail;
    }
    return "it does not work here";
  }
  const auto& layers = expected.layers;
  if (std::find(layers.begin(), layers.end(), static_cast<int>(layer)) == layers.end()) {
    return "not promised there";
  }
  const int version = landlock_version(sandbox);
  if (layer != Layer::kNamespaces && version < expected.needs_landlock) {
    return "Landlock here is of version " + std::to_string(version);
  }
  if (layer == Layer::kSameUser && (version == 0 || !sandbox.filters_calls)) {
    return "without Landlock and seccomp it protects against accidents only";
  }
  return {};
}

Report attack(const std::string& name, const Sandbox& sandbox, const Limits& limits,
              const CrimeScene& scene) {
  Assignment assignment = read_assignment(standard_assignment());
  assignment.limits = limits;
  Submission submission = find_submission(kAttacks / name, assignment.submission);
  submission.headers.push_back({"attack.h", bytes_of(kAttacks / "attack.h")});
  submission.headers.push_back({"paths.h", scene.paths_header()});
  Home home = find_home();
  home.sandbox = sandbox;
  return grade(assignment, submission, home, {"vertex_normal"}, [](const std::string&) {});
}

bool has_control_character(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7F;
  });
}

void expect_harmless_text(const std::string& page) {
  EXPECT_FALSE(has_control_character(page));
  for (const char* turning : {"\xE2\x80\xAE", "\xE2\x81\xA6", "\xC2\x85", "\xC2\x9B"})
    EXPECT_EQ(page.find(turning), std::string::npos);
}

void expect_no_harm(const Report& report, const AttackExpectation& expected,
                    const CrimeScene& scene) {
  const std::string json = to_json(report);
  const std::string page = to_terminal(report, {false, true, {}});
  SCOPED_TRACE(page.substr(0, 4000));
  EXPECT_TRUE(nlohmann::json::accept(json));
  expect_harmless_text(json);
  expect_harmless_text(page);
  EXPECT_FALSE(report.has_grader_error());
  EXPECT_EQ(report.points, expected.points);
  if (expected.verdicts != std::vector<std::string>{"any"}) {
    EXPECT_THAT(expected.verdicts,
                testing::Contains(verdict_name(report.exercises.at(0).verdict)));
  }
  for (const std::string& text : expected.says)
    EXPECT_NE(page.find(text), std::string::npos) << "the report does not say: " << text;
  for (const std::string& text : {std::string("BREACH"), "HiddenCase" + scene.secret()})
    EXPECT_EQ(page.find(text), std::string::npos) << "the report says: " << text;
  for (const std::string& text : expected.hides)
    EXPECT_EQ(page.find(text), std::string::npos) << "the report says: " << text;
}

class Attack : public testing::TestWithParam<std::string> {};

TEST_P(Attack, DoesNoHarm) {
  const AttackExpectation expected = read_attack(kAttacks / GetParam(), quick_limits());
  for (const Layer layer : {Layer::kNamespaces, Layer::kOtherUser, Layer::kSameUser}) {
    SCOPED_TRACE("layer " + layer_name(layer));
    const Home home = find_home();
    const Sandbox sandbox = find_sandbox(home.kit, home.compiler, layer);
    const std::string reason = obstacle(sandbox, layer, expected);
    if (!reason.empty()) {
      std::cout << "not tried in layer " << layer_name(layer) << ": " << reason << "\n";
      continue;
    }
    const CrimeScene scene;
    expect_no_harm(attack(GetParam(), sandbox, expected.limits, scene), expected, scene);
    for (const std::string& trace : scene.traces())
      ADD_FAILURE() << trace;
  }
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

INSTANTIATE_TEST_SUITE_P(Attacks, Attack, testing::ValuesIn(attack_names()), test_name);

}  // namespace
}  // namespace meshgrade
