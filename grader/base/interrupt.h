#pragma once

namespace meshgrade {

/// The program is to end because of a signal. Not an exception that anything else handles: on
/// its way to main() all temporary folders are deleted.
struct Interrupted {
  int signal = 0;
};

/// From now on Ctrl-C (SIGINT), SIGTERM and SIGHUP end the program only when its temporary
/// folders are gone: whatever runs then is ended, and run_process throws Interrupted. Without
/// temporary folders, or when asked a second time, it ends at once. What was ignored when the
/// program was started, as by nohup, stays so.
void end_in_order_when_interrupted();

/// The signal that has come, or 0.
int interruption();

/// Ends the program as the signal would have done by itself.
[[noreturn]] void end_by(const Interrupted& interrupted);

/// Tells that there is one thing more (1) or less (-1) to delete before the program ends.
void count_leftovers(int change);

}  // namespace meshgrade
