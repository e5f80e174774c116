#include "grader/judge/misconception.h"

#include <gtest/gtest.h>

#include "grader/judge/tell_apart.h"

namespace meshgrade {
namespace {

const Misconceptions kKnown{{"half", "this is the half"}, {"zero", "this is nothing"}};

std::vector<std::string> names_of(const Misconceptions& list) {
  std::vector<std::string> names;
  for (const Misconception& m : list)
    names.push_back(m.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(Misconception, IsNamedOnceAndOnlyWhereAllPointsAgree) {
  const std::vector<Point3> actual{{0, 0, 0}, {1, 0, 0}};
  const std::vector<Prediction<Point3>> predictions{
      {"half", {{0, 0, 0}, {1, 0, 1e-9}}}, {"half", actual}, {"zero", {{0, 0, 0}, {0, 0, 0}}}};
  EXPECT_EQ(names_of(recognize(kKnown, predictions, actual, 1e-6)), Names{"half"});
  EXPECT_EQ(names_of(recognize(kKnown, predictions, {}, 1e-6)), Names{});
  EXPECT_EQ(names_of(recognize(kKnown, predictions, {{0, 0, 0}}, 1e-6)), Names{});
}

TEST(Misconception, PointThatIsNoNumberAgreesWithSuchAPointOnly) {
  const Point3 nothing{NAN, 0, -INFINITY};
  EXPECT_TRUE(agrees<Point3>({{NAN, NAN, NAN}}, {nothing}, 1e-6));
  EXPECT_FALSE(agrees<Point3>({{0, 0, 0}}, {nothing}, 1e-6));
  EXPECT_FALSE(agrees<Point3>({nothing}, {{0, 0, 0}}, 1e-6));
}

TEST(Misconception, NameThatIsNotInTheListIsAFaultOfTheGrader) {
  const std::vector<Prediction<Point3>> predictions{{"third", {{0, 0, 0}}}};
  EXPECT_THROW(recognize(kKnown, predictions, {{0, 0, 0}}, 1e-6), GraderError);
}

CaseJudgement judgement_naming(const Misconceptions& likely) {
  CaseJudgement judgement;
  judgement.findings.emplace_back();
  judgement.findings[0].likely = likely;
  return judgement;
}

TEST(TellApart, KeepsWhatAnotherCaseNamesAlone) {
  CaseJudgement both = judgement_naming(kKnown);
  CaseJudgement one = judgement_naming({kKnown[1]});
  CaseJudgement none = judgement_naming({});
  tell_apart({&both, &one, &none});
  EXPECT_EQ(names_of(both.findings[0].likely), Names{"zero"});
  EXPECT_EQ(names_of(one.findings[0].likely), Names{"zero"});
  EXPECT_EQ(names_of(none.findings[0].likely), Names{});
}

TEST(TellApart, KeepsAllWhereNoCaseIsCertain) {
  CaseJudgement first = judgement_naming(kKnown);
  CaseJudgement second = first;
  tell_apart({&first, &second});
  EXPECT_EQ(names_of(first.findings[0].likely), (Names{"half", "zero"}));
}

}  // namespace
}  // namespace meshgrade
