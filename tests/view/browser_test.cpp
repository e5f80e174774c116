// A browser without a display takes a picture of a page.

#include "grader/view/browser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "grader/base/process.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// Points TMPDIR and PATH to folders of the test's own.
class Browser : public testing::Test {
 protected:
  Browser() {
    const char* path = std::getenv("PATH");
    path_ = path != nullptr ? path : "";
    fs::create_directory(folder_.path() / "bin");
  }
  ~Browser() override { ::setenv("PATH", path_.c_str(), 1); }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// A program of this name that does as a shell script says.
  fs::path pretend(const std::string& name, const std::string& script) const {
    const fs::path file = folder_.path() / "bin" / name;
    std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(file, fs::perms::owner_all);
    return file;
  }

  ScratchFolder folder_;
  std::string path_;
};

TEST_F(Browser, IsFoundByAnyOfItsNamesAndNotWhereThereIsNone) {
  ::setenv("PATH", (folder_.path() / "bin").c_str(), 1);
  EXPECT_EQ(find_browser(), fs::path());
  const fs::path chrome = pretend("google-chrome", "exit 0");
  EXPECT_EQ(find_browser(), chrome);
  const fs::path chromium = pretend("chromium", "exit 0");
  EXPECT_EQ(find_browser(), chromium);
}

TEST_F(Browser, ThatFailsSaysWhy) {
  const Photograph none =
      photograph(pretend("chromium", "echo no room; exit 4"), "", {}, false);
  EXPECT_EQ(none.png, "");
  EXPECT_THAT(none.why, testing::HasSubstr("took no picture; its last line: no room"));
  const Photograph other = photograph(
      pretend("chromium", "for a; do case $a in --screenshot=*) echo x > ${a#*=};; esac; done"),
      "", {}, false);
  EXPECT_EQ(other.png, "");
  EXPECT_THAT(other.why, testing::HasSubstr("no PNG"));
}

TEST_F(Browser, LeavesNoProfileBehind) {
  const fs::path seen = folder_.path() / "seen";
  photograph(pretend("chromium",
                     "for a; do case $a in --user-data-dir=*) mkdir ${a#*=}; "
                     "echo ${a#*=} > " +
                         seen.string() + ";; esac; done"),
             "", {}, false);
  std::string profile;
  std::ifstream(seen) >> profile;
  ASSERT_NE(profile, "");
  EXPECT_FALSE(fs::exists(fs::path(profile).parent_path()));
}

TEST_F(Browser, TakesAPictureOfTheSizeThatIsAskedFor) {
  const fs::path browser = find_browser();
  if (browser.empty()) GTEST_SKIP() << "no Chromium or Chrome is on the PATH";
  const Photograph taken =
      photograph(browser, "<!doctype html><title>x</title><p>here", {321, 123}, false);
  ASSERT_GT(taken.png.size(), 24U) << taken.why;
  const auto number_at = [&](std::size_t place) {
    int number = 0;
    for (std::size_t i = place; i < place + 4; ++i)
      number = 256 * number + static_cast<unsigned char>(taken.png[i]);
    return number;
  };
  EXPECT_EQ(number_at(16), 321);
  EXPECT_EQ(number_at(20), 123);
}

}  // namespace
}  // namespace meshgrade
