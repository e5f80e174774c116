#include "grader/cases/case_list.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/standard_assignment.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

std::vector<Case> all_cases(const Assignment& assignment) {
  std::vector<Case> all;
  for (const ExerciseRubric& rubric : assignment.exercises) {
    for (Case& c : make_cases(assignment, rubric, MESHGRADE_SOURCE_DIR "/meshes"))
      all.push_back(std::move(c));
  }
  return all;
}

TEST(CaseList, TwoCallsGiveTheSameBytes) {
  const std::vector<Case> a = all_cases(standard_rubric());
  const std::vector<Case> b = all_cases(standard_rubric());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].id(), b[i].id());
    EXPECT_EQ(a[i].title, b[i].title);
    EXPECT_EQ(a[i].input, b[i].input);
    EXPECT_EQ(a[i].step_budget, b[i].step_budget);
  }
}

TEST(CaseList, HiddenCasesComeOnTopAndAreOthers) {
  Assignment with_hidden = standard_rubric();
  with_hidden.hidden = HiddenCases{"", 99, HiddenShow::kName};
  for (const ExerciseRubric& rubric : with_hidden.exercises) {
    const std::vector<Case>& handed_out = standard_cases(rubric.name);
    const std::vector<Case> all =
        make_cases(with_hidden, rubric, MESHGRADE_SOURCE_DIR "/meshes");
    ASSERT_GT(all.size(), handed_out.size()) << rubric.name;
    std::set<std::string> ids;
    std::set<std::string> inputs;
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_TRUE(ids.insert(all[i].id()).second) << all[i].id();
      EXPECT_EQ(all[i].hidden, i >= handed_out.size());
      const bool fresh = inputs.insert(all[i].group + all[i].input).second;
      EXPECT_TRUE(fresh || !all[i].hidden) << all[i].id();
      EXPECT_TRUE(all[i].hidden || all[i].id() == handed_out[i].id());
    }
  }
}

TEST(CaseList, WithoutTheirSeedThereAreNoHiddenCases) {
  Assignment handed_out = standard_rubric();
  handed_out.hidden = HiddenCases{"secret", std::nullopt, HiddenShow::kName};
  const ExerciseRubric& flip = *handed_out.find("edge_flip");
  EXPECT_EQ(make_cases(handed_out, flip, MESHGRADE_SOURCE_DIR "/meshes").size(),
            standard_cases("edge_flip").size());
}

TEST(CaseList, AnotherSeedGivesOtherRandomCasesInEveryExercise) {
  Assignment other = standard_rubric();
  other.seed += 1;
  for (const ExerciseRubric& rubric : other.exercises) {
    const std::vector<Case>& first = standard_cases(rubric.name);
    const std::vector<Case> second = make_cases(other, rubric, MESHGRADE_SOURCE_DIR "/meshes");
    std::set<std::string> inputs;
    for (const Case& c : first)
      inputs.insert(c.input);
    std::size_t fresh = 0;
    for (const Case& c : second)
      fresh += inputs.count(c.input) == 0 ? 1 : 0;
    EXPECT_GT(fresh, 0U) << rubric.name;
    EXPECT_EQ(first.size(), second.size()) << rubric.name;
  }
}

TEST(CaseList, IdsAreUniqueAndLeadBackToTheirCase) {
  std::set<std::string> ids;
  for (const Case& c : all_cases(standard_rubric())) {
    EXPECT_TRUE(ids.insert(c.id()).second) << c.id();
    EXPECT_FALSE(c.title.empty());
    EXPECT_GT(c.step_budget, 0U);
  }
  const Case& c = standard_case("edge_split:boundary/3");
  EXPECT_EQ(find_case(standard_rubric(), MESHGRADE_SOURCE_DIR "/meshes", c.id()).input,
            c.input);
  for (const char* wrong : {"edge_split:boundary/9999", "edge_split", "", "x:y/1", "::/"}) {
    EXPECT_NE(user_error(
                  [&] { find_case(standard_rubric(), MESHGRADE_SOURCE_DIR "/meshes", wrong); }),
              "");
  }
}

TEST(CaseList, EveryGroupOfTheStandardAssignmentHasCases) {
  for (const ExerciseRubric& rubric : standard_rubric().exercises) {
    std::set<std::string> groups;
    for (const Case& c : standard_cases(rubric.name))
      groups.insert(c.group);
    for (const Group& group : rubric.groups)
      EXPECT_EQ(groups.count(group.name), 1U) << rubric.name << " " << group.name;
    EXPECT_EQ(groups.size(), rubric.groups.size());
  }
}

TEST(CaseList, GroupsThatAreNotAskedForAreLeftOut) {
  Assignment assignment = standard_rubric();
  ExerciseRubric rubric = *assignment.find("edge_flip");
  rubric.groups.resize(1);
  for (const Case& c : make_cases(assignment, rubric, MESHGRADE_SOURCE_DIR "/meshes"))
    EXPECT_EQ(c.group, rubric.groups[0].name);
}

TEST(CaseList, UnknownExercisesAndGroupsAreRefusedByName) {
  const Assignment& assignment = standard_rubric();
  ExerciseRubric rubric = *assignment.find("edge_flip");
  const auto message = [&] {
    return user_error([&] { make_cases(assignment, rubric, MESHGRADE_SOURCE_DIR "/meshes"); });
  };
  rubric.groups[0].name = "bassic";
  EXPECT_NE(message().find("bassic"), std::string::npos);
  rubric.name = "edge_flop";
  EXPECT_NE(message().find("edge_flop"), std::string::npos);
}

TEST(CaseList, MissingMeshFileIsNamed) {
  const ExerciseRubric& rubric = *standard_rubric().find("edge_flip");
  EXPECT_NE(
      user_error([&] { make_cases(standard_rubric(), rubric, "/nowhere"); }).find("/nowhere"),
      std::string::npos);
}

}  // namespace
}  // namespace meshgrade
