#pragma once

// The worker's side of the exercises: each unpacks an input, calls the student's function, and
// records what it left behind. None knows what the right answer is.

#include "grader/base/wire.h"
#include "grader/worker/recorder.h"

namespace meshgrade {

#define MESHGRADE_EXERCISE(name) void run_##name(WireReader& input, Recorder& recorder);
#include "exercise_list.inc"
#undef MESHGRADE_EXERCISE
#define MESHGRADE_LOCAL_OPERATION(name) void run_##name(WireReader& input, Recorder& recorder);
#include "local_operation_list.inc"
#undef MESHGRADE_LOCAL_OPERATION

}  // namespace meshgrade
