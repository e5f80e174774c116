#pragma once

#include "grader/base/wire.h"
#include "grader/worker/recorder.h"

namespace meshgrade {

/// Unpacks an OperationsInput, calls flipEdge and splitEdge, and records an OperationStep for
/// each. Stops when an edge that was asked for is not there.
void run_mesh_operations(WireReader& input, Recorder& recorder);

}  // namespace meshgrade
