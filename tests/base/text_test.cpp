#include "grader/base/text.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "grader/base/random.h"

namespace meshgrade {
namespace {

TEST(Printable, PlainTextStaysByteForByte) {
  const std::string text =
      "tab\tline\n half-edge h12 -> v3, \xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80";
  EXPECT_EQ(printable(text), text);
}

TEST(Printable, EveryControlCharacterButTabAndNewlineBecomesVisible) {
  for (int c = 0; c < 0x20; ++c) {
    const std::string text(1, static_cast<char>(c));
    EXPECT_EQ(printable(text), c == '\t' || c == '\n' ? text : "?") << c;
  }
  EXPECT_EQ(printable("\x7F"), "?");
}

TEST(Printable, AnsiEscapesLoseTheirPower) {
  EXPECT_EQ(printable("\033[2J\033[31mred\033[0m"), "?[2J?[31mred?[0m");
  EXPECT_EQ(printable("\033]0;title\007"), "?]0;title?");
  EXPECT_EQ(printable("100\rpassed\b\b"), "100?passed??");
}

TEST(Printable, ControlCharactersBehindAsciiAreNoWayAround) {
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "??31m");  // the C1 form of ESC [
  EXPECT_EQ(printable("\xC2\xA0"), "\xC2\xA0");
}

TEST(Printable, InvalidUtf8BecomesVisible) {
  EXPECT_EQ(printable("\x80"), "?");
  EXPECT_EQ(printable("\xC3"), "?");                 // cut off
  EXPECT_EQ(printable("\xC0\x80"), "??");            // overlong zero
  EXPECT_EQ(printable("\xE0\x80\x80"), "???");       // overlong
  EXPECT_EQ(printable("\xED\xA0\x80"), "???");       // a surrogate
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "????");  // beyond Unicode
  EXPECT_EQ(printable("\xF0\x80\x80\x80"), "????");  // overlong
  EXPECT_EQ(printable("\xFF\xFE"), "??");
  EXPECT_EQ(printable("\xE2\x82"
                      "A"),
            "??A");
}

TEST(Printable, CharactersThatTurnTextAroundBecomeVisible) {
  for (const char* turn : {"\xE2\x80\xAA", "\xE2\x80\xAE", "\xE2\x81\xA6", "\xE2\x81\xA9",
                           "\xE2\x80\x8F", "\xE2\x80\x8B", "\xE2\x80\xA8"}) {
    EXPECT_EQ(printable(std::string("a") + turn + "b"), "a?b");
  }
}

TEST(Printable, AnyBytesBecomeCleanTextThatStaysAsItIs) {
  Random random(1, "bytes");
  for (int round = 0; round < 2000; ++round) {
    std::string bytes;
    for (std::uint32_t i = random.below(12); i > 0; --i)
      bytes +=
          static_cast<char>(random.below(3) == 0 ? random.below(256) : 0xE0 + random.below(32));
    const std::string clean = printable(bytes);
    EXPECT_EQ(printable(clean), clean);
    EXPECT_LE(clean.size(), bytes.size());
    for (char c : clean)
      EXPECT_FALSE(static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n');
  }
}

TEST(HtmlText, NothingInItIsMarkup) {
  EXPECT_EQ(html_text("<a href=\"x\">&\x1b</a>\n"),
            "&lt;a href=&quot;x&quot;&gt;&amp;?&lt;/a&gt;\n");
}

TEST(SplitLines, JoinedLinesAreTheTextAgain) {
  EXPECT_EQ(split_lines("a\n\nb"), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(split_lines("a\n"), (std::vector<std::string>{"a"}));
  EXPECT_TRUE(split_lines("").empty());
  EXPECT_EQ(join(split_lines("x\ny\nz"), "\n"), "x\ny\nz");
}

TEST(NumberText, WritesNumbersAsAPersonWould) {
  EXPECT_EQ(number_text(0.5), "0.5");
  EXPECT_EQ(number_text(3.0), "3");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(-std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(number_text(1.0 / 3.0, 3), "0.333");
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(PointText, ListsTheCoordinates) {
  EXPECT_EQ(point_text(std::array<double, 3>{0.5, 1.0, 0.0}), "(0.5, 1, 0)");
  EXPECT_EQ(point_text(std::array<double, 2>{-2.0, 1e-7}), "(-2, 1e-07)");
}

TEST(Plural, OneIsSingular) {
  EXPECT_EQ(plural(0, "edge"), "0 edges");
  EXPECT_EQ(plural(1, "edge"), "1 edge");
  EXPECT_EQ(plural(2, "half-edge"), "2 half-edges");
}

}  // namespace
}  // namespace meshgrade
