#include "grader/similarity/similarity_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshgrade {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kLong =
    "if (a < b) { c = a->next()->twin()->vertex()->position; d = b->next()->face(); }";

std::string page_of(const std::string& first_key, const std::string& text, std::size_t shown) {
  const SharedCode code({{first_key, {{"<i>.cpp", text}}}, {"bob", {{"b.cpp", kLong}}}}, {},
                        20);
  return similarity_page(code, code.pairs(1), shown);
}

TEST(SimilarityPage, MarksWhatIsShared) {
  const std::string page = page_of("ann", "int own;\n" + kLong, 5);
  EXPECT_THAT(page, HasSubstr("<h2>ann and bob</h2>"));
  EXPECT_THAT(page, HasSubstr("<pre>int own;\n<mark>if (a &lt; b)"));
  EXPECT_THAT(page, HasSubstr("<li>ann, bob</li>"));
  EXPECT_THAT(page, HasSubstr("href=\"#pair1\""));
}

TEST(SimilarityPage, ShowsOnlySoManySources) {
  const std::string page = page_of("ann", kLong, 0);
  EXPECT_THAT(page, HasSubstr("<td>ann</td>"));
  EXPECT_THAT(page, Not(HasSubstr("<pre>")));
}

TEST(SimilarityPage, IsNotRuledByWhatIsHandedIn) {
  const std::string page =
      page_of("<script>x</script>", kLong + "// </pre><script>y</script>", 5);
  EXPECT_THAT(page, Not(HasSubstr("<script>")));
  EXPECT_THAT(page, Not(HasSubstr("<i>")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;x"));
}

TEST(SimilarityPage, SaysWhenThereAreNoGroups) {
  EXPECT_THAT(similarity_page(SharedCode({}, {}, 20), {}, 5), HasSubstr("No two have 50 % or"));
}

}  // namespace
}  // namespace meshgrade
