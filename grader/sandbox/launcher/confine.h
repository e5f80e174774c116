#pragma once

#include "grader/sandbox/launcher/options.h"

namespace meshgrade::launcher {

// Each of these takes rights away from this process, for good. All throw a Refusal if that
// does not work.

/// Resource limits; core files are never written.
void limit_resources(const Options& options);

/// Another user, without groups and capabilities. Does nothing if none is asked for.
void change_user(const Options& options);

/// No program that is started from now on gets more rights than its parent.
void forbid_new_privileges();

#ifdef __linux__
/// Landlock: files, and, as far as this kernel knows how, network and signals.
void bound_files(const Options& options);

/// seccomp: what a submission never needs. Some calls fail with EPERM, those that libraries try
/// and do without fail as though the kernel did not know them.
void filter_calls();
#endif

}  // namespace meshgrade::launcher
