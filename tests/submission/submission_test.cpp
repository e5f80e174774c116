#include "grader/submission/submission.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/scratch_files.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

class FindSubmission : public testing::Test {
 protected:
  fs::path add(const std::string& name, const std::string& text = "int a;\n") {
    return write_file(root_ / name, text);
  }
  Submission find(const SubmissionRules& rules = {}) { return find_submission(root_, rules); }

  ScratchFolder folder_;
  fs::path root_ = folder_.path() / "mueller";
};

std::vector<std::string> names(const std::vector<SourceFile>& files) {
  std::vector<std::string> list;
  for (const SourceFile& file : files)
    list.push_back(file.name);
  return list;
}

using Names = std::vector<std::string>;

TEST_F(FindSubmission, TakesSourcesAndHeadersOfAFolderInOrder) {
  add("b.cpp", "text of b");
  add("a.cc");
  add("c.cxx");
  add("h.h");
  add("i.hpp");
  add("notes.txt");
  add("a.out");
  add("deeper/d.cpp");
  const Submission submission = find();
  EXPECT_EQ(submission.name, "mueller");
  EXPECT_EQ(names(submission.sources), (Names{"a.cc", "b.cpp", "c.cxx"}));
  EXPECT_EQ(names(submission.headers), (Names{"h.h", "i.hpp"}));
  EXPECT_EQ(submission.sources[1].text, "text of b");
  EXPECT_TRUE(submission.notes.empty());
}

TEST_F(FindSubmission, FolderThatOnlyWrapsAnotherIsLookedThrough) {
  add("outer/inner/a.cpp");
  add("__MACOSX/x");
  add(".DS_Store");
  EXPECT_EQ(names(find().sources), (Names{"a.cpp"}));
}

/// The units of a text below U+10000, lower or higher byte first.
std::string utf16(const std::u16string& text, bool little, bool marked) {
  std::string bytes;
  for (const char16_t unit : (marked ? u"\uFEFF" : u"") + text) {
    const char low = static_cast<char>(unit & 0xFF);
    const char high = static_cast<char>(unit >> 8);
    bytes += little ? std::string{low, high} : std::string{high, low};
  }
  return bytes;
}

TEST_F(FindSubmission, Utf16OfVisualStudioBecomesUtf8WithTheSameLines) {
  const std::u16string text =
      u"// Gr\u00F6\u00DFe \u2192 \U0001F600\r\nint a;\r\n\r\nint b;\r\n";
  for (const bool little : {true, false}) {
    for (const bool marked : {true, false}) {
      add("a.cpp", utf16(text, little, marked));
      add("a.h", utf16(text, little, marked));
      const Submission submission = find();
      const std::string expected =
          "// Gr\xC3\xB6\xC3\x9F"
          "e \xE2\x86\x92 \xF0\x9F\x98\x80\r\nint a;\r\n\r\nint b;\r\n";
      EXPECT_EQ(submission.sources.at(0).text, expected);
      EXPECT_EQ(submission.headers.at(0).text, expected);
      ASSERT_EQ(submission.notes.size(), 2U);
      EXPECT_EQ(submission.notes[0].find("a.cpp is saved as UTF-16"), 0U);
    }
  }
}

TEST_F(FindSubmission, Utf16ThatIsCutOffIsNoDisaster) {
  add("a.cpp", utf16(u"int a;\n", true, true) + std::string("\x00\xD8", 2) + "x");
  EXPECT_EQ(find().sources.at(0).text, "int a;\n\xEF\xBF\xBD");
}

TEST_F(FindSubmission, OtherBytesStayAsTheyAre) {
  for (const std::string& text :
       {std::string("int \xE4;\n"), std::string("\xEF\xBB\xBFint a;\n"), std::string(),
        std::string("a"), std::string("int a\0b;\n", 9)}) {
    add("a.cpp", text);
    EXPECT_EQ(find().sources.at(0).text, text);
    EXPECT_TRUE(find().notes.empty());
  }
}

TEST_F(FindSubmission, Utf32IsLeftOutInOneSentence) {
  add("a.cpp");
  add("b.cpp", std::string("\xFF\xFE\0\0i\0\0\0", 8));
  EXPECT_EQ(names(find().sources), (Names{"a.cpp"}));
  EXPECT_EQ(find().notes, (Names{"b.cpp is left out: it is saved as UTF-32, which no compiler "
                                 "reads; save it as UTF-8"}));
}

TEST_F(FindSubmission, TwoFoldersAreNotGuessedAt) {
  add("one/a.cpp");
  add("two/a.cpp");
  EXPECT_NE(user_error([&] { find(); }), "");
}

TEST_F(FindSubmission, SingleFileIsASubmission) {
  const fs::path file = add("only.cpp", "x");
  add("other.cpp");
  const Submission submission = find_submission(file, {});
  EXPECT_EQ(names(submission.sources), (Names{"only.cpp"}));
  EXPECT_EQ(submission.sources[0].text, "x");
}

TEST_F(FindSubmission, HiddenFilesAreNoSources) {
  add("a.cpp");
  add("._a.cpp", "what macOS puts into archives");
  add(".b.cpp");
  EXPECT_EQ(names(find().sources), (Names{"a.cpp"}));
}

TEST_F(FindSubmission, LinksAndPipesAreLeftOutWithANote) {
  add("a.cpp");
  fs::create_symlink("/etc/passwd", root_ / "link.cpp");
  ASSERT_EQ(::mkfifo((root_ / "pipe.cpp").c_str(), 0600), 0);
  fs::create_directory(root_ / "folder.cpp");
  const Submission submission = find();
  EXPECT_EQ(names(submission.sources), (Names{"a.cpp"}));
  ASSERT_EQ(submission.notes.size(), 3U);
  EXPECT_NE(submission.notes[0].find("folder.cpp"), std::string::npos);
  EXPECT_NE(submission.notes[1].find("link.cpp"), std::string::npos);
  EXPECT_NE(submission.notes[2].find("pipe.cpp"), std::string::npos);
}

TEST_F(FindSubmission, LargeFilesAreLeftOutWithANote) {
  SubmissionRules rules;
  rules.file_kb = 1;
  add("just.cpp", std::string(1024, ' '));
  add("over.cpp", std::string(1025, ' '));
  const Submission submission = find(rules);
  EXPECT_EQ(names(submission.sources), (Names{"just.cpp"}));
  ASSERT_EQ(submission.notes.size(), 1U);
  EXPECT_NE(submission.notes[0].find("over.cpp"), std::string::npos);
  EXPECT_NE(submission.notes[0].find("1 KB"), std::string::npos);
}

TEST_F(FindSubmission, MoreFilesThanAllowedAreLeftOutWithANote) {
  SubmissionRules rules;
  rules.files = 2;
  for (const char* name : {"a.cpp", "b.cpp", "c.cpp"})
    add(name);
  const Submission submission = find(rules);
  EXPECT_EQ(submission.sources.size(), 2U);
  EXPECT_EQ(submission.notes.size(), 1U);
}

TEST_F(FindSubmission, HeadersComeAlongOnlyWhereTheyMay) {
  add("a.cpp");
  add("a.h");
  SubmissionRules rules;
  rules.headers = false;
  const Submission submission = find(rules);
  EXPECT_TRUE(submission.headers.empty());
  ASSERT_EQ(submission.notes.size(), 1U);
  EXPECT_NE(submission.notes[0].find("a.h"), std::string::npos);
}

TEST_F(FindSubmission, NamesThatTheCompilerMightMisreadAreLeftOut) {
  add("a.cpp");
  add("-o.cpp");
  add("a b.cpp");
  add("x\033[31m.cpp");
  const Submission submission = find();
  EXPECT_EQ(names(submission.sources), (Names{"a.cpp"}));
  ASSERT_EQ(submission.notes.size(), 3U);
  for (const std::string& note : submission.notes)
    EXPECT_EQ(note.find('\033'), std::string::npos);
}

TEST_F(FindSubmission, NothingToGradeIsSaidWithThePath) {
  fs::create_directories(root_);
  const std::string empty = user_error([&] { find(); });
  EXPECT_NE(empty.find(root_.string()), std::string::npos);
  EXPECT_EQ(empty.find('\n'), std::string::npos);
  EXPECT_NE(user_error([&] { find_submission(root_ / "nowhere", {}); }).find("nowhere"),
            std::string::npos);
  EXPECT_NE(user_error([&] { find_submission(add("notes.txt"), {}); }), "");
}

TEST_F(FindSubmission, NameDoesNotDependOnHowTheFolderIsWritten) {
  add("a.cpp");
  EXPECT_EQ(find_submission(root_.string() + "/", {}).name, "mueller");
  EXPECT_EQ(find_submission(root_ / ".." / "mueller", {}).name, "mueller");
}

}  // namespace
}  // namespace meshgrade
