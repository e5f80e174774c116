#include "grader/mutants/adequacy.h"

#include <gtest/gtest.h>

#include "grader/app/adequacy_check.h"

namespace meshgrade {
namespace {

AdequacyOptions nothing() {
  AdequacyOptions options;
  options.mutants = 1;
  options.variants = 0;
  options.repeated = 0;
  return options;
}

Adequacy measure(const AdequacyOptions& options) {
  return measure_standard_adequacy(options,
                                   [](const std::string&, std::size_t, std::size_t) {});
}

TEST(Adequacy, ASampleOfMutantsIsKilledOrReviewed) {
  AdequacyOptions options = nothing();
  options.mutants = 15;
  options.styles = {"reference", "textbook"};  // whose survivors have all been reviewed
  const Adequacy adequacy = measure(options);
  EXPECT_EQ(adequacy.mutants.size(), 15U);
  EXPECT_EQ(adequacy.unexplained, std::vector<std::string>());
  EXPECT_EQ(adequacy.outdated, std::vector<std::string>());
  EXPECT_EQ(adequacy.grader_errors, std::vector<std::string>());
  EXPECT_GE(functions_named(adequacy).percent(), 90.0);
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

}  // namespace
}  // namespace meshgrade
