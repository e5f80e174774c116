#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>

namespace meshgrade {

/// What a process and all its descendants use.
struct TreeUse {
  std::uint64_t memory = 0;   ///< bytes of real memory, not counting files
  std::size_t processes = 0;  ///< threads count as processes
};

/// Looks at this moment's processes. Orphans count only if a descendant has adopted them. All
/// is 0 where the system does not tell (macOS).
TreeUse use_of_tree(pid_t root);

/// All processes and threads of a user, as the system counts them for RLIMIT_NPROC; 0 where it
/// does not tell (macOS).
std::size_t processes_of_user(uid_t user);

}  // namespace meshgrade
