// `meshgrade hint`, and the hints of the exercises' pages.

#include "grader/commands/hint_command.h"

#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(FindHints, TakesTheItemsUnderTheHeadingOnly) {
  EXPECT_THAT(find_hints("# Page\n\n1. Not this.\n\n## Hints\n\n1. First,\n   on two lines.\n"
                         "2. Second.\n\n## After\n\n3. Nor this.\n"),
              ElementsAre("First,\non two lines.", "Second."));
}

TEST(FindHints, FindsNoneOnAPageWithoutThem) {
  EXPECT_TRUE(find_hints("# Page\n\n1. A list.\n").empty());
}

class HintCommand : public CommandLine {};

TEST_F(HintCommand, GivesOneMoreEachTimeUntilThereAreNoMore) {
  EXPECT_THAT(call({"hint", "edge_flip"}).output, HasSubstr("hint 1 of "));
  EXPECT_THAT(call({"hint", "edge_flip"}).output, HasSubstr("hint 2 of "));
  call({"hint", "edge_flip", "--all"});
  const Said said = call({"hint", "edge_flip"});
  EXPECT_EQ(said.status, 0);
  EXPECT_THAT(said.output, HasSubstr("there are no more hints for edge_flip"));
}

TEST_F(HintCommand, AgainRepeatsAndResetBeginsAnew) {
  call({"hint", "edge_flip"});
  call({"hint", "edge_flip"});
  EXPECT_THAT(call({"hint", "edge_flip", "--again"}).output, HasSubstr("hint 2 of "));
  call({"hint", "edge_flip", "--reset"});
  EXPECT_THAT(call({"hint", "edge_flip"}).output, HasSubstr("hint 1 of "));
}

TEST_F(HintCommand, CountsForEachExerciseAndSubmissionAlone) {
  call({"hint", "edge_flip", reference()});
  EXPECT_THAT(call({"hint", "edge_split", reference()}).output, HasSubstr("hint 1 of "));
  EXPECT_THAT(call({"hint", "edge_flip", folder_.string()}).output, HasSubstr("hint 1 of "));
}

TEST_F(HintCommand, EveryExerciseHasHints) {
  for (const char* exercise : {"bezier_curve", "bezier_patch", "vertex_normal", "edge_flip",
                               "edge_split", "loop_subdivision"}) {
    EXPECT_EQ(call({"hint", exercise}).status, 0) << exercise;
  }
}

TEST_F(HintCommand, TellsOfAnExerciseThatDoesNotExist) {
  const Said said = call({"hint", "edge_flop"});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("edge_flip"));
}

}  // namespace
}  // namespace meshgrade
