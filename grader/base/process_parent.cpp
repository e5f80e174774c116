#include "grader/base/process_parent.h"

#ifdef __linux__
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#endif

namespace meshgrade {

void die_with([[maybe_unused]] pid_t parent, [[maybe_unused]] int status) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(status);  // it died before that
#endif
}

}  // namespace meshgrade
