// The verbs of the viewer and their keys come from the operations.

#include "grader/view/view_verbs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "grader/operations/local_operation_list.h"
#include "grader/view/picture_request.h"
#include "tests/support/standard_assignment.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ViewVerbs, EveryOperationOfTheAssignmentHasOneWithWhatItPicks) {
  const std::vector<ViewVerb> verbs = view_verbs(polygon_rubric());
  EXPECT_TRUE(are_for_polygons(verbs));
  for (const ExerciseRubric& rubric : polygon_rubric().exercises) {
    const LocalOperation* operation = find_local_operation(rubric.name);
    if (operation == nullptr) continue;
    const std::string word = operation->verb.substr(0, operation->verb.find(' '));
    const ViewVerb* verb = find_verb(verbs, word, operation->picks);
    ASSERT_NE(verb, nullptr) << rubric.name;
    EXPECT_EQ(verb->exercise, rubric.name);
    EXPECT_EQ(verb->picked, operation->picks_two ? 2U : 1U);
  }
}

TEST(ViewVerbs, WordsHaveAKeyEachAndTakeNoneOfTheView) {
  std::map<std::string, std::string> words;
  const std::string taken = "adhintpvwyzqZ";
  for (const ViewVerb& verb : view_verbs(polygon_rubric())) {
    ASSERT_EQ(verb.keys.size(), 1U) << verb.word;
    EXPECT_EQ(taken.find(verb.keys), std::string::npos) << verb.word;
    const auto [known, is_new] = words.emplace(verb.keys, verb.word);
    EXPECT_EQ(known->second, verb.word);
  }
}

TEST(ViewVerbs, AnAssignmentWithoutPolygonsHasTheThreeOfTriangles) {
  for (const Assignment& assignment : {standard_rubric(), Assignment()}) {
    const std::vector<ViewVerb> verbs = view_verbs(assignment);
    ASSERT_EQ(verbs.size(), 3U);
    EXPECT_FALSE(are_for_polygons(verbs));
    EXPECT_EQ(verbs[2].word, "subdivide");
  }
}

TEST(ViewVerbs, StepsOfPolygonsAreReadByTheKindOfTheirElements) {
  const std::vector<ViewVerb> verbs = view_verbs(polygon_rubric());
  const auto steps =
      parse_steps("collapse e3, collapse f2, weld e3 e7, catmull-clark 2", verbs);
  ASSERT_EQ(steps.size(), 5U);
  EXPECT_EQ(steps[0].exercise, "edge_collapse");
  EXPECT_EQ(steps[1].exercise, "face_collapse");
  EXPECT_EQ(operation_text(steps[2]), "weld e3 e7");
  EXPECT_EQ(operation_text(steps[4]), "catmull-clark");
  for (const char* bad : {"collapse v3", "weld e3", "weld e3 f2", "bevel f1", "flip e1 e2",
                          "extrude", "catmull-clark 9", "subdivide", "collapse 3"}) {
    EXPECT_THAT(user_error([&] { parse_steps(bad, verbs); }),
                AllOf(HasSubstr("step 1"), HasSubstr("for example --steps \"flip e3")))
        << bad;
  }
}

}  // namespace
}  // namespace meshgrade
