#include "grader/similarity/shared_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "grader/similarity/code_tokens.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;

/// A function of many tokens, other ones for each number.
std::string function(int number) {
  std::string text = "double f" + std::to_string(number) + "(double x) {\n";
  for (int i = 0; i < 12; ++i) {
    text += "  x = x * " + std::to_string(number * 100 + i) + ".5 + halfedge->next()->step" +
            std::to_string(i) + "();\n";
  }
  return text + "  return x;\n}\n";
}

HandInText hand_in(const std::string& key, const std::vector<std::string>& texts) {
  HandInText made{key, {}};
  for (const std::string& text : texts)
    made.files.push_back({"file" + std::to_string(made.files.size()) + ".cpp", text});
  return made;
}

/// How much of the first is in the second, and the other way round.
std::pair<int, int> shares(const std::vector<std::string>& first,
                           const std::vector<std::string>& second,
                           const std::vector<SourceFile>& handed_out = {}) {
  const SharedCode code({hand_in("a", first), hand_in("b", second)}, handed_out, 20);
  const auto pairs = code.pairs(1);
  return pairs.empty() ? std::pair(0, 0) : std::pair(pairs[0].of_first, pairs[0].of_second);
}

TEST(CodeTokens, NamesCountAsTheSameAndMembersAsWhatTheyAre) {
  const auto same = [](const std::string& a, const std::string& b) {
    const auto first = code_tokens(a);
    const auto second = code_tokens(b);
    return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                      [](const CodeToken& x, const CodeToken& y) { return x.what == y.what; });
  };
  EXPECT_TRUE(same("h = other->next();", "x=y -> next ( ) ; // a comment"));
  EXPECT_FALSE(same("h = other->next();", "h = other->twin();"));
  EXPECT_FALSE(same("a * 0.5", "a * 0.25"));
  EXPECT_FALSE(same("if (a)", "while (a)"));
  EXPECT_TRUE(same("double l\xC3\xA4nge = 1e-5;", "double b = 1e-5;"));
}

TEST(CodeTokens, KnowTheirPlaces) {
  const std::string text = "a = b /* c */ ->x;";
  std::vector<std::string> words;
  for (const CodeToken& token : code_tokens(text))
    words.push_back(text.substr(token.begin, token.end - token.begin));
  EXPECT_THAT(words, ElementsAre("a", "=", "b", "->", "x", ";"));
}

TEST(SharedCode, OfTheSameIsAll) {
  EXPECT_EQ(shares({function(1)}, {function(1)}), std::pair(100, 100));
}

TEST(SharedCode, OfNothingInCommonIsNone) {
  EXPECT_EQ(shares({function(1)}, {function(2)}), std::pair(0, 0));
}

TEST(SharedCode, DoesNotDependOnOrderOrFiles) {
  const auto [first, second] = shares({function(1) + function(2) + function(3)},
                                      {function(3), function(1) + function(2)});
  EXPECT_GE(first, 95);
  EXPECT_GE(second, 95);
}

TEST(SharedCode, OfHalfIsHalf) {
  const auto [first, second] = shares({function(1) + function(2)}, {function(2)});
  EXPECT_NEAR(first, 50, 3);
  EXPECT_GE(second, 95);
}

TEST(SharedCode, LeavesOutWhatWasHandedOut) {
  EXPECT_EQ(shares({function(1)}, {function(1)}, {{"given.cpp", function(1)}}),
            std::pair(0, 0));
  const auto [first, second] = shares({function(1) + function(2)}, {function(1) + function(3)},
                                      {{"given.cpp", function(1)}});
  EXPECT_LE(std::max(first, second), 15);  // where two functions meet
}

TEST(SharedCode, CountsLessWhatManyHave) {
  std::vector<HandInText> texts;
  for (int i = 0; i < 40; ++i) {
    std::string text = function(i + 10);
    if (i < 5) text += function(1);   // a twentieth of them wrote this alike
    if (i < 20) text += function(2);  // and half of them that
    if (i == 38 || i == 39) text += function(3);
    texts.push_back(hand_in("s" + std::to_string(i), {text}));
  }
  const auto pairs = SharedCode(std::move(texts), {}, 20).pairs(1);
  ASSERT_EQ(pairs.size(), 1U + 10U);
  EXPECT_EQ(pairs[0].first, "s38");
  EXPECT_EQ(pairs[0].second, "s39");
  EXPECT_NEAR(pairs[0].of_first, 50, 3);
  EXPECT_LT(pairs[1].most(), 45);
}

TEST(SharedCode, SaysWhichPartsAreShared) {
  const std::string mine = function(1) + function(2);
  const SharedCode code({hand_in("a", {mine}), hand_in("b", {function(2)})}, {}, 20);
  const auto parts = code.shared_parts(0, 1);
  ASSERT_EQ(parts.size(), 1U);
  ASSERT_EQ(parts[0].size(), 1U);
  const std::string part = mine.substr(parts[0][0].begin, parts[0][0].end - parts[0][0].begin);
  EXPECT_NE(part.find("200.5"), std::string::npos);
  EXPECT_NE(part.find("return x;\n}"), std::string::npos);
  EXPECT_EQ(part.find("100.5"), std::string::npos);
}

TEST(SharedCode, OfShortOrEmptyFilesIsNothing) {
  EXPECT_EQ(shares({"int a;"}, {"int a;"}), std::pair(0, 0));
  EXPECT_EQ(shares({}, {""}), std::pair(0, 0));
  EXPECT_THAT(SharedCode({}, {}, 20).pairs(1), testing::IsEmpty());
}

TEST(Groups, AreConnectedByPairs) {
  const std::vector<SimilarPair> pairs{{"a", "b", 90, 20, 0, 1},
                                       {"c", "b", 10, 70, 2, 1},
                                       {"d", "e", 60, 60, 3, 4},
                                       {"e", "f", 49, 49, 4, 5}};
  EXPECT_THAT(groups_of(pairs, 50),
              ElementsAre(ElementsAre("a", "b", "c"), ElementsAre("d", "e")));
}

}  // namespace
}  // namespace meshgrade
