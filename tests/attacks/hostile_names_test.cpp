// Names of files that are commands somewhere, and files that are none: what a folder in a
// repository cannot hold.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "grader/commands/context.h"
#include "grader/grade/grading.h"
#include "grader/report/json_report.h"
#include "grader/report/terminal_report.h"
#include "tests/attacks/traces.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

class HostileNames : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
  }

  Report grade_folder() const {
    const Assignment assignment = read_assignment(standard_assignment());
    write("right.cpp", "int right = 1;\n");
    return grade(assignment, find_submission(folder_.path(), assignment.submission),
                 find_home(), {"vertex_normal"}, [](const std::string&) {});
  }

  ScratchFolder folder_;  // made first, so that it is no trace on the scene
  CrimeScene scene_;
};

TEST_F(HostileNames, NameThatIsACommandIsLeftOutAndNeverRun) {
  const std::string touch = "touch meshgrade-attack-" + scene_.secret();
  for (const std::string& name :
       {"$(" + touch + ").cpp", "`" + touch + "`.cpp", "; " + touch + " #.cpp",
        "a && " + touch + ".cpp", std::string("-fplugin=evil.cpp"), std::string("@flags.cpp"),
        std::string("-o victim.cpp"), std::string("a\nb.cpp"), std::string("\"quoted\".cpp"),
        std::string("\033[2Jclear.cpp"), std::string("=cmd().cpp"), std::string("%s%n.cpp"),
        std::string("\xE2\x80\xAEppc.evil.cpp")}) {
    write(name, "#error this was compiled\n");
  }
  const Report report = grade_folder();
  EXPECT_EQ(report.files.size(), 1U);
  EXPECT_EQ(report.notes.size(), 13U);
  const std::string page = to_terminal(report, {false, true, {}}) + to_json(report);
  EXPECT_EQ(page.find("this was compiled"), std::string::npos);
  EXPECT_EQ(page.find('\033'), std::string::npos);
  EXPECT_EQ(page.find("\xE2\x80\xAE"), std::string::npos);
  EXPECT_TRUE(scene_.traces().empty());
  EXPECT_FALSE(fs::exists("meshgrade-attack-" + scene_.secret()));
}

TEST_F(HostileNames, LinkFifoAndDeviceAreLeftOutWithoutWaiting) {
  fs::create_symlink("/etc/passwd", folder_.path() / "link.cpp");
  fs::create_symlink("/dev/zero", folder_.path() / "zero.h");
  fs::create_symlink("link.cpp", folder_.path() / "second.cpp");
  fs::create_symlink("loop.cpp", folder_.path() / "loop.cpp");
  ASSERT_EQ(::mkfifo((folder_.path() / "fifo.cpp").c_str(), 0644), 0);
  fs::create_directory(folder_.path() / "folder.cpp");
  const Report report = grade_folder();
  EXPECT_EQ(report.files.size(), 1U);
  EXPECT_EQ(report.notes.size(), 6U);
  EXPECT_EQ(to_json(report).find("root:"), std::string::npos);
}

TEST_F(HostileNames, RequireSandboxRefusesOnlyWeakLayers) {
  Sandbox sandbox;
  sandbox.probes = {{"layer 1 (namespaces)", false, "bubblewrap is not installed"}};
  for (const Layer weak : {Layer::kSameUser, Layer::kNone}) {
    sandbox.layer = weak;
    const std::string message = user_error([&] { require_sandbox(sandbox); });
    EXPECT_NE(message.find("bubblewrap is not installed"), std::string::npos) << message;
    EXPECT_NE(message.find("doctor"), std::string::npos) << message;
  }
  for (const Layer strong : {Layer::kNamespaces, Layer::kOtherUser}) {
    sandbox.layer = strong;
    EXPECT_EQ(user_error([&] { require_sandbox(sandbox); }), "");
  }
}

}  // namespace
}  // namespace meshgrade
