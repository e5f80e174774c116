#include <grp.h>
#include <sys/resource.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "grader/sandbox/launcher/confine.h"

namespace meshgrade::launcher {
namespace {

#ifdef __linux__
using Resource = __rlimit_resource;
#else
using Resource = int;
#endif

void limit(Resource resource, std::uint64_t value, const char* name) {
  rlimit limits{};
  if (::getrlimit(resource, &limits) != 0)
    refuse(std::string("cannot read the limit of ") + name);
  // A limit that is lower already stays.
  if (limits.rlim_max == RLIM_INFINITY || limits.rlim_max > value) limits.rlim_max = value;
  limits.rlim_cur = limits.rlim_max;
  if (::setrlimit(resource, &limits) != 0) refuse(std::string("cannot limit ") + name);
}

void limit_if_asked(Resource resource, const std::optional<std::uint64_t>& value,
                    const char* name) {
  if (value) limit(resource, *value, name);
}

}  // namespace

void limit_resources(const Options& options) {
  limit(RLIMIT_CORE, 0, "core files");
  limit_if_asked(RLIMIT_CPU, options.cpu_seconds, "processor time");
  limit_if_asked(RLIMIT_AS, options.memory_bytes, "memory");
  limit_if_asked(RLIMIT_FSIZE, options.file_bytes, "files");
  limit_if_asked(RLIMIT_NPROC, options.processes, "processes");
  limit_if_asked(RLIMIT_NOFILE, options.open_files, "open files");
#ifdef __linux__
  limit(RLIMIT_MSGQUEUE, 0, "message queues");
  limit(RLIMIT_RTPRIO, 0, "real-time priority");
#endif
}

void change_user(const Options& options) {
  if (!options.user) return;
  const auto user = static_cast<uid_t>(*options.user);
  if (::setgroups(0, nullptr) != 0) refuse("cannot leave the groups");
  if (::setregid(user, user) != 0) refuse("cannot change the group");
  if (::setreuid(user, user) != 0) refuse("cannot change the user");
  if (::getuid() != user || ::geteuid() != user || ::setuid(0) == 0) {
    throw Refusal("the user could be changed back");
  }
}

void forbid_new_privileges() {
#ifdef __linux__
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) refuse("cannot forbid new privileges");
#endif
}

}  // namespace meshgrade::launcher
