#include "tests/attacks/traces.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLeftBehind = "meshgrade-attack-";
constexpr const char* kVictim = "the instructor's results\n";

void write(const fs::path& file, const std::string& text, mode_t mode) {
  std::ofstream(file) << text;
  ::chmod(file.c_str(), mode);
}

std::string random_word() {
  std::ostringstream word;
  word << std::hex << std::random_device()() << std::random_device()();
  return word.str();
}

}  // namespace

std::string bytes_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

CrimeScene::CrimeScene() : scratch_(folder_.path() / "scratch"), secret_(random_word()) {
  // Open to all: what is inside must be safe all the same.
  ::chmod(folder_.path().c_str(), 0755);
  write(folder_.path() / "secret.txt", "HiddenCase" + secret_ + ";\n", 0644);
  write(folder_.path() / "results.txt", kVictim, 0666);
  fs::create_directory(scratch_);
  const char* before = std::getenv("TMPDIR");
  if (before != nullptr) before_ = before;
  ::setenv("TMPDIR", scratch_.c_str(), 1);
  ::setenv("MESHGRADE_TOKEN", secret_.c_str(), 1);
  listener_ = FileDescriptor(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof here;
  ::bind(listener_.get(), reinterpret_cast<sockaddr*>(&here), size);
  ::listen(listener_.get(), 1);
  ::getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&here), &size);
  port_ = ntohs(here.sin_port);
}

CrimeScene::~CrimeScene() {
  if (before_.empty()) {
    ::unsetenv("TMPDIR");
  } else {
    ::setenv("TMPDIR", before_.c_str(), 1);
  }
}

std::string CrimeScene::paths_header() const {
  const auto text = [](const fs::path& path) { return "\"" + path.string() + "\"\n"; };
  return "#pragma once\n#define SECRET_FILE " + text(folder_.path() / "secret.txt") +
         "#define VICTIM_FILE " + text(folder_.path() / "results.txt") + "#define SCRATCH " +
         text(scratch_) + "#define PROJECT " + text(MESHGRADE_SOURCE_DIR) +
         "#define LEFT_BEHIND " + text(kLeftBehind + secret_) + "#define LISTENING_PORT " +
         std::to_string(port_) + "\n";
}

/// Whatever was started in the scratch folder.
std::vector<pid_t> CrimeScene::left_processes() const {
  std::vector<pid_t> found;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    const int process = std::atoi(entry.path().filename().c_str());
    if (process <= 0 || process == ::getpid()) continue;
    std::error_code ignored;
    const std::string program = fs::read_symlink(entry.path() / "exe", ignored).string();
    const std::string words = bytes_of(entry.path() / "cmdline");
    if ((program + words).find(scratch_.string()) != std::string::npos) {
      found.push_back(process);
    }
  }
  return found;
}

void CrimeScene::add_left_files(std::vector<std::string>& found) const {
  for (const fs::directory_entry& entry : fs::directory_iterator(scratch_))
    found.push_back("a scratch file is left: " + entry.path().string());
  for (const char* folder : {"/", "/tmp", "/var/tmp", "/dev/shm", "/run", "/dev/mqueue"}) {
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
      const std::string name = it->path().filename().string();
      const bool own = name.find(secret_) != std::string::npos;
      const bool fixed = name.rfind(kLeftBehind, 0) == 0 && !std::isxdigit(name.back());
      if (own || fixed) found.push_back("a file is left: " + it->path().string());
    }
  }
}

std::vector<std::string> CrimeScene::traces() const {
  std::vector<std::string> found;
  // The kernel takes a moment to end a whole namespace.
  for (int i = 0; i < 200 && !left_processes().empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  for (pid_t process : left_processes()) {
    found.push_back("a process is left: " + std::to_string(process));
    ::kill(process, SIGKILL);
  }
  add_left_files(found);
  const fs::path victim = folder_.path() / "results.txt";
  if (bytes_of(victim) != kVictim) found.emplace_back("the instructor's file was changed");
  if (fs::exists(victim) && fs::hard_link_count(victim) != 1) {
    found.emplace_back("the instructor's file was linked");
  }
  pollfd caller{listener_.get(), POLLIN, 0};
  if (::poll(&caller, 1, 0) != 0) found.emplace_back("somebody has connected");
  return found;
}

}  // namespace meshgrade
