#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

#include "grader/sandbox/launcher/confine.h"

namespace meshgrade::launcher {
namespace {

// What linux/landlock.h of Linux 6.1 does not know yet.
struct RulesetAttributes {
  std::uint64_t files = 0;
  std::uint64_t network = 0;
  std::uint64_t scopes = 0;
};
constexpr std::uint64_t kAllOfVersion1 = (1ULL << 13U) - 1;
constexpr std::uint64_t kRefer = 1ULL << 13U;           // version 2
constexpr std::uint64_t kTruncate = 1ULL << 14U;        // version 3
constexpr std::uint64_t kAllNetwork = 3;                // version 4: bind and connect, TCP
constexpr std::uint64_t kDeviceControls = 1ULL << 15U;  // version 5
constexpr std::uint64_t kAllScopes = 3;                 // version 6: abstract sockets, signals

constexpr std::uint64_t kRead = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kRun = kRead | LANDLOCK_ACCESS_FS_EXECUTE;
constexpr std::uint64_t kWrite =
    kRun | kRefer | kTruncate | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_FILE |
    LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_DIR;
constexpr std::uint64_t kForFiles = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_EXECUTE |
                                    LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate;

RulesetAttributes all_of_version(long version, bool own_signals) {
  RulesetAttributes all;
  all.files = kAllOfVersion1;
  if (version >= 2) all.files |= kRefer;
  if (version >= 3) all.files |= kTruncate;
  if (version >= 4) all.network = kAllNetwork;
  if (version >= 5) all.files |= kDeviceControls;
  if (version >= 6 && own_signals) all.scopes = kAllScopes;
  return all;
}

/// Older kernels know only the first fields.
std::size_t size_of_version(long version) {
  return version >= 6 ? 24 : version >= 4 ? 16 : 8;
}

void allow(int ruleset, const std::string& path, std::uint64_t access) {
  const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (file < 0 && errno == ENOENT) return;  // what is not there needs no rule
  struct stat status {};
  if (file < 0 || ::fstat(file, &status) != 0) refuse("cannot open " + path);
  if (!S_ISDIR(status.st_mode)) access &= kForFiles;
  landlock_path_beneath_attr rule{};
  rule.allowed_access = access;
  rule.parent_fd = file;
  if (::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0) {
    refuse("cannot allow " + path);
  }
  ::close(file);
}

}  // namespace

void bound_files(const Options& options) {
  const long version =
      ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) refuse("this kernel offers no Landlock");
  const RulesetAttributes handled = all_of_version(version, options.own_signals);
  const long made =
      ::syscall(SYS_landlock_create_ruleset, &handled, size_of_version(version), 0);
  if (made < 0) refuse("cannot make a Landlock ruleset");
  const int ruleset = static_cast<int>(made);
  for (const std::string& path : options.read)
    allow(ruleset, path, kRead & handled.files);
  for (const std::string& path : options.run)
    allow(ruleset, path, kRun & handled.files);
  for (const std::string& path : options.write)
    allow(ruleset, path, kWrite & handled.files);
  if (::syscall(SYS_landlock_restrict_self, ruleset, 0) != 0) refuse("cannot use Landlock");
  ::close(ruleset);
}

}  // namespace meshgrade::launcher
