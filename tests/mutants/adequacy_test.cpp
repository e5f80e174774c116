#include "grader/mutants/adequacy.h"

#include <gtest/gtest.h>

#include "grader/commands/adequacy_check.h"
#include "grader/mutants/adequacy_page.h"

namespace meshgrade {
namespace {

AdequacyOptions nothing() {
  AdequacyOptions options;
  options.mutants = 1;
  options.variants = 0;
  options.repeated = 0;
  options.single_pointers = false;
  return options;
}

Adequacy measure(const AdequacyOptions& options) {
  return measure_standard_adequacy(options,
                                   [](const std::string&, std::size_t, std::size_t) {});
}

TEST(Adequacy, ASampleOfMutantsIsKilledOrReviewed) {
  AdequacyOptions options = nothing();
  options.mutants = 15;  // of those that docs/adequacy.md is about
  const Adequacy adequacy = measure(options);
  EXPECT_EQ(adequacy.mutants.size(), 15U);
  EXPECT_EQ(adequacy.unexplained, std::vector<std::string>());
  EXPECT_EQ(adequacy.outdated, std::vector<std::string>());
  EXPECT_EQ(adequacy.grader_errors, std::vector<std::string>());
  EXPECT_GE(functions_named(adequacy).percent(), 90.0);
}

TEST(Adequacy, ASampleOfTheSecondAssignmentIsKilledOrReviewed) {
  AdequacyOptions options = nothing();
  options.assignment = "polygon_meshes";
  options.mutants = 12;
  const Adequacy adequacy = measure(options);
  EXPECT_EQ(adequacy.mutants.size(), 12U);
  EXPECT_EQ(adequacy.unexplained, std::vector<std::string>());
  EXPECT_EQ(adequacy.outdated, std::vector<std::string>());
  EXPECT_EQ(adequacy.grader_errors, std::vector<std::string>());
}

TEST(Adequacy, RightVariantsHaveFullPoints) {
  AdequacyOptions options = nothing();
  options.variants = 10;
  options.seed = 7;
  const Adequacy adequacy = measure(options);
  EXPECT_GE(adequacy.variants.drawn, 10U);
  EXPECT_EQ(adequacy.variants.refused, std::vector<std::string>());
}

TEST(Adequacy, TheSameSubmissionGivesTheSameBytesAloneAndBesideOthers) {
  AdequacyOptions options = nothing();
  options.mutants = 3;
  options.repeated = 2;
  options.exercise = "edge_flip";
  const Adequacy adequacy = measure(options);
  EXPECT_GT(adequacy.determinism.submissions, 0U);
  EXPECT_EQ(adequacy.determinism.differing, std::vector<std::string>());
}

TEST(SinglePointers, AreListedAloneAndNamedFirst) {
  AdequacyOptions options = nothing();
  options.single_pointers = true;
  options.exercise = "edge_split";
  options.styles = {"turned"};
  const Adequacy adequacy = measure(options);
  ASSERT_EQ(adequacy.single_pointers.size(), 1U);
  const SinglePointers& sums = adequacy.single_pointers[0];
  EXPECT_EQ(sums.solution, "turned");
  EXPECT_GT(sums.tried, 1000U);
  EXPECT_GE(100 * sums.alone, 99 * sums.tried);
  EXPECT_GE(100 * sums.first, 95 * sums.tried);
}

MutantResult with_points(double whole, double parts, std::size_t wrong_pointers) {
  MutantResult result;
  result.mutant.exercise = "edge_flip";
  result.fate = Fate::kKilled;
  result.points_without_parts = whole;
  result.points = parts;
  for (std::size_t i = 0; i < wrong_pointers; ++i)
    result.wrong_pointers.insert("h" + std::to_string(i) + ".next");
  return result;
}

TEST(AdequacyPage, TellsWhatOneWrongPointerCosts) {
  Adequacy adequacy;
  adequacy.exercises = {"edge_flip", "edge_split"};
  adequacy.mutants = {with_points(0.0, 0.9, 1), with_points(0.5, 0.25, 1),
                      with_points(0.15, 0.6, 1), with_points(1.0, 1.0, 2)};
  const std::string page = to_markdown(adequacy);
  EXPECT_NE(page.find("| edge_flip | 3 | 0 / 15 / 50 % | 25 / 60 / 90 % |\n"),
            std::string::npos)
      << page;
  EXPECT_EQ(page.find("| edge_split | 3"), std::string::npos);
}

TEST(MutantPoints, OfOneWrongPointerAreAPart) {
  AdequacyOptions options = nothing();
  options.mutants = 5;
  options.exercise = "edge_flip";
  options.styles = {"textbook"};
  std::size_t counted = 0;
  for (const MutantResult& result : measure(options).mutants) {
    if (result.fate != Fate::kKilled || result.wrong_pointers.size() != 1) continue;
    EXPECT_GT(result.points, 0.0) << result.mutant.id();
    EXPECT_LT(result.points, 1.0) << result.mutant.id();
    EXPECT_LE(result.points_without_parts, result.points) << result.mutant.id();
    ++counted;
  }
  EXPECT_GT(counted, 0U);
}

}  // namespace
}  // namespace meshgrade
