#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/judge/deviation.h"
#include "grader/judge/mesh_scene.h"
#include "grader/judge/misconception.h"
#include "grader/judge/pointer_diff.h"
#include "grader/judge/ring_figure.h"
#include "grader/judge/surface_figure.h"
#include "grader/run/outcome.h"

namespace meshgrade {

enum class Verdict {
  kPassed,
  kFailed,
  kNotImplemented,
  kNotCompiled,
  kCrashed,
  kOutOfTime,
  kOutOfSteps,
  kOutOfMemory,
  kTooMuchOutput,
  kTooManyProcesses,
  kTooManyFiles,
  kNotJudged,    ///< something that this depends on failed: no statement is made
  kGraderError,  ///< a fault of the grader, never of the student
};

/// "passed", "failed", "not implemented", ...
const char* verdict_name(Verdict verdict);

/// The verdict of this name, if there is one.
std::optional<Verdict> find_verdict(const std::string& name);

/// One thing that is wrong, with all that a student needs to see it.
struct Finding {
  std::string rule;     ///< short name: "twin-opposite", "value", "unset-handle"
  std::string meaning;  ///< what the rule asks, as a sentence
  std::string where;    ///< "after operation 2 of 6 (flip v0-v3)"; empty if it is plain
  std::string element;  ///< "h12", "v3", "point 2"
  std::string expected;
  std::string actual;
  std::string look_at;            ///< pointer, function or idea to look at first
  std::vector<StackFrame> stack;  ///< the student's frames, innermost first
  Misconceptions likely;          ///< what it probably comes from; the numbers agree
  PointerDiff pointers;           ///< all pointers around a flipped or split edge, or empty
  SurfaceFigure surface;          ///< the subdivided mesh with its wrong vertices, or empty
  RingFigure ring;                ///< the faces around an operation on polygons, or empty
};

/// What the judge says about a case.
struct CaseJudgement {
  Verdict verdict = Verdict::kPassed;
  std::vector<Finding> findings;  ///< the most telling first; empty if passed
  std::string note;               ///< for example why the case is not judged
  /// Of a case that failed: how many of the pointers that had to change are right, from 0 to 1.
  double right_share = 0.0;
  /// Not judged, because the judge saw that another exercise is to blame: takes no points.
  bool excused = false;
  /// The code keeps something from one call to the next: alone, this case passes.
  bool passes_alone = false;
  MeshScene scene;      ///< the step that went wrong, for a viewer; mostly empty
  Deviation deviation;  ///< of a subdivision, where it was asked for; else empty
};

}  // namespace meshgrade
