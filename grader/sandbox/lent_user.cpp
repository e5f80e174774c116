#include "grader/sandbox/lent_user.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "grader/base/errors.h"
#include "grader/base/process_tree.h"

namespace meshgrade {
namespace {

// Neither Debian (60000 to 60799 and from 61000) nor systemd (up to 60705 and from 61184) gives
// these to anybody, and a container with 65536 users has them.
constexpr uid_t kFirst = 60800;
constexpr uid_t kCount = 200;

/// Where a file is locked for each user that is lent. Not in /tmp, where others could put
/// links in its place.
constexpr const char* kLocks = "/run/meshgrade-users";

[[noreturn]] void fail(const std::string& what) {
  throw GraderError(what + ": " + std::strerror(errno));
}

void make_lock_folder() {
  if (::mkdir(kLocks, 0700) != 0 && errno != EEXIST) {
    fail(std::string("cannot make ") + kLocks);
  }
  struct stat status {};
  if (::lstat(kLocks, &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != 0) {
    throw GraderError(std::string(kLocks) + " must be a folder of root's");
  }
}

bool is_somebody(uid_t number) {
  passwd entry{};
  passwd* found = nullptr;
  std::array<char, 4096> buffer{};
  return ::getpwuid_r(number, &entry, buffer.data(), buffer.size(), &found) == 0 &&
         found != nullptr;
}

}  // namespace

LentUser::LentUser() {
  if (::geteuid() != 0) throw GraderError("only root can start programs as another user");
  make_lock_folder();
  // Each process begins at another number, so that graders that do not see each other's locks
  // hardly ever ask for the same one at the same moment.
  const uid_t start = static_cast<uid_t>(::getpid()) % kCount;
  for (uid_t i = 0; i < kCount; ++i) {
    const uid_t number = kFirst + (start + i) % kCount;
    const std::string name = std::string(kLocks) + "/" + std::to_string(number);
    FileDescriptor lock(::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (lock.get() < 0) fail("cannot open " + name);
    if (::flock(lock.get(), LOCK_EX | LOCK_NB) != 0 || is_somebody(number)) continue;
    // Lent by a grader in another container, which has locks of its own: two containers may
    // share the numbers of processes and users without sharing files.
    if (processes_of_user(number) > 0) continue;
    number_ = number;
    lock_ = std::move(lock);
    return;
  }
  throw GraderError("all users for confined programs are in use");
}

LentUser::~LentUser() {
  // Closing alone is not enough: a process that is just being started has a copy.
  ::flock(lock_.get(), LOCK_UN);
}

LentFolder::LentFolder(std::filesystem::path folder, const LentUser& user)
    : folder_(std::move(folder)) {
  if (::chown(folder_.c_str(), user.number(), user.number()) != 0 ||
      ::chmod(folder_.c_str(), 0700) != 0) {
    fail("cannot give away " + folder_.string());
  }
}

LentFolder::~LentFolder() {
  // If that fails, the folder has been taken away: there is nothing left to protect.
  if (::lchown(folder_.c_str(), 0, 0) != 0) return;
}

}  // namespace meshgrade
