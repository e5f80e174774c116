#pragma once

#include <cstdint>
#include <optional>

namespace meshgrade::launcher {

/// Splits this process in two. Returns in the new one, which goes on to become the program, in
/// a session of its own. The old one stays until the program has ended, or SIGTERM comes, or
/// its own parent has died; then it ends all that is left and ends like the program did.
/// @param user  the program's user: all that belongs to it is ended. If there is none, what is
///              ended are the descendants
/// @throws Refusal if no process can be made
void supervise(const std::optional<std::uint64_t>& user);

/// This process ends with its parent. Holds until it changes its user.
void end_with_parent(int signal);

}  // namespace meshgrade::launcher
