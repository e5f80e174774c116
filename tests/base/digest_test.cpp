#include "grader/base/digest.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

TEST(Digest, IsSha256) {
  // From FIPS 180-2, appendix B.1.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Digest, KnowsWhereATextEnds) {
  EXPECT_NE(Digest().add("a").add("bc").hex(), Digest().add("ab").add("c").hex());
  EXPECT_EQ(Digest().add("a").add("bc").hex(), Digest().add("a").add("bc").hex());
}

}  // namespace
}  // namespace meshgrade
