#pragma once

#include <string>

#include "grader/base/wire.h"
#include "grader/worker/recorder.h"

namespace meshgrade {

/// Runs the exercise of this name: calls the student's function and records what it left.
using RunExercise = void (*)(const std::string& exercise, WireReader& input,
                             Recorder& recorder);

/// Unpacks a ViewInput, calls the functions of its exercises on one mesh of polygons, and
/// records a PolygonViewStep for each. Stops at an element that is not there, and where a mesh
/// cannot be built anew.
void run_polygon_view(WireReader& input, Recorder& recorder, RunExercise run);

}  // namespace meshgrade
