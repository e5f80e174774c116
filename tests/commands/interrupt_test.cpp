// Whoever ends the program early does not find the student's code in the temporary folder.

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

class Interrupt : public CommandLine {
 protected:
  Interrupt() {
    fs::create_directory(temporary_);
    // As root, submissions run as other users.
    fs::permissions(scratch_.path(), fs::perms(0711));
    fs::permissions(temporary_, fs::perms(0711));
  }

  bool is_empty() const { return fs::is_empty(temporary_); }

  /// Calls the program, and sends it a signal when it has made a temporary folder.
  /// @return how it ended, as waitpid says
  int call_and_send(int signal, const std::vector<std::string>& arguments) const {
    std::vector<char*> words{const_cast<char*>(MESHGRADE_PROGRAM)};
    for (const std::string& argument : arguments)
      words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
      ::setenv("TMPDIR", temporary_.c_str(), 1);
      ::freopen("/dev/null", "w", stdout);
      ::execv(words[0], words.data());
      ::_exit(127);
    }
    for (int i = 0; i < 3000 && is_empty(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_FALSE(is_empty()) << "it has begun";
    std::this_thread::sleep_for(std::chrono::milliseconds(300));  // it compiles
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
  }

  fs::path temporary_ = scratch_.path() / "tmp";
};

TEST_F(Interrupt, LeavesNothingBehindAndEndsByTheSignal) {
  const std::string sleeps = wrong("edge_flip/sleeps");
  write("flip.cpp",
        "#include <unistd.h>\n#include \"meshedit/meshedit.h\"\nnamespace meshedit {\n"
        "EdgeIter HalfedgeMesh::flipEdge(EdgeIter e) {\n  ::pause();\n  return e;\n}\n}\n");
  const std::string picture = (scratch_.path() / "a.svg").string();
  const std::vector<std::vector<std::string>> calls{
      {"check", sleeps, "edge_flip"},
      {"replay", "edge_flip:stress/11", sleeps, "--sanitize"},
      {"view", "--submission", folder_, "--screenshot", picture, "--steps", "flip e0"}};
  for (const auto& arguments : calls) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      const int status = call_and_send(signal, arguments);
      EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal)
          << arguments[0] << ", signal " << signal << ", ended with " << status;
      EXPECT_TRUE(is_empty()) << arguments[0] << ", signal " << signal;
    }
  }
}

}  // namespace
}  // namespace meshgrade
