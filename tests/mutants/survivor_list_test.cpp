#include "grader/mutants/survivor_list.h"

#include <gtest/gtest.h>

#include <fstream>

#include "grader/base/errors.h"
#include "grader/base/process.h"

namespace meshgrade {
namespace {

SurvivorList read(const std::string& text) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "survivors.toml";
  std::ofstream(file) << text;
  return read_survivor_list(file);
}

TEST(SurvivorList, EveryMutantOfAGroupHasItsReason) {
  const SurvivorList list = read(
      "[[group]]\nreason = 'r'\nmutants = ['a', 'b']\n"
      "[[group]]\nreason = 's'\nmutants = ['c']\n");
  EXPECT_EQ(list, SurvivorList({{"a", "r"}, {"b", "r"}, {"c", "s"}}));
}

TEST(SurvivorList, AnEmptyFileIsAnEmptyList) {
  EXPECT_TRUE(read("").empty());
}

TEST(SurvivorList, RefusesWhatHasNoReasonOrComesTwice) {
  EXPECT_THROW(read("[[group]]\nmutants = ['a']\n"), UserError);
  EXPECT_THROW(read("[[group]]\nreason = 'r'\nmutants = [1]\n"), UserError);
  EXPECT_THROW(read("[[group]]\nreason = 'r'\nmutants = ['a', 'a']\n"), UserError);
  EXPECT_THROW(read("[[group\n"), UserError);
}

}  // namespace
}  // namespace meshgrade
