// The text of a write-up, as Markdown and as HTML.

#include "grader/writeup/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshgrade {
namespace {

using testing::HasSubstr;
using testing::Not;

Writeup hostile() {
  const std::string text = "<script>x</script> [a](b) `c` *d*";
  return {text, text, {{text, text, {{"pictures/a.png", text, text + "\nsecond line"}}}}};
}

TEST(WriteupDocument, HasEachItemWithRoomForWordsAndItsPictures) {
  const Writeup writeup{"T", "hw", {{"Flip", "Explain.", {{"pictures/a.png", "After", ""}}}}};
  for (const std::string& text : {to_markdown(writeup), to_html(writeup)}) {
    for (const char* part : {"Flip", "Explain.", "Your words here", "pictures/a.png", "After"})
      EXPECT_THAT(text, HasSubstr(part));
    EXPECT_THAT(text, Not(HasSubstr("Not right yet")));
  }
}

TEST(WriteupDocument, SaysWhatWentWrong) {
  for (const std::string& text : {to_markdown(hostile()), to_html(hostile())}) {
    EXPECT_THAT(text, HasSubstr("Not right yet"));
    EXPECT_THAT(text, HasSubstr("second line"));
  }
}

TEST(WriteupDocument, TextOfOthersStaysText) {
  EXPECT_THAT(to_html(hostile()), Not(HasSubstr("<script")));
  const std::string markdown = to_markdown(hostile());
  for (const char* live : {" <script", " [a](b)", " `c`", " *d*"})
    EXPECT_THAT(markdown, Not(HasSubstr(live)));
}

}  // namespace
}  // namespace meshgrade
