#pragma once

namespace meshgrade {

/// Thrown by run_process when another thread wants its result no more.
struct Cancelled {};

/// While this lives, run_process ends what it runs and throws Cancelled, in all threads.
class Cancellation {
 public:
  Cancellation();
  ~Cancellation();
  Cancellation(const Cancellation&) = delete;
  Cancellation& operator=(const Cancellation&) = delete;
};

bool is_cancelled();

}  // namespace meshgrade
