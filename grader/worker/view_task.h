#pragma once

#include "grader/base/wire.h"
#include "grader/worker/recorder.h"

namespace meshgrade {

/// Unpacks a ViewInput, calls the student's functions, and records a ViewStep for each. Stops
/// at an edge that is not there.
void run_view(WireReader& input, Recorder& recorder);

}  // namespace meshgrade
