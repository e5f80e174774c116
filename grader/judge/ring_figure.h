#pragma once

// The faces around an element that an operation was about, as a picture shows them: before, as
// the student left them, and as they must be. Data only: how it is drawn is the report's
// business.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grader/judge/face_match.h"
#include "grader/operations/local_operation.h"

namespace meshgrade {

/// In place of a number: not on the rim.
constexpr std::size_t kInsideRim = SIZE_MAX;

struct RingVertex {
  std::string name;              ///< "v3"; "new" if the student has none for it
  std::size_t rim = kInsideRim;  ///< its place on the rim, the same in all panels
  bool is_picked = false;
};

struct RingFace {
  std::string name;                  ///< "f3"; empty if it is no face of the student's
  std::vector<std::size_t> corners;  ///< places in the panel's vertices, counter-clockwise
  bool is_picked = false;
  bool differs = false;  ///< of yours: not asked for; of what is expected: not there
};

struct RingPanel {
  std::vector<RingVertex> vertices;
  std::vector<RingFace> faces;
};

/// No rim: there is no picture.
struct RingFigure {
  RingPanel before;
  RingPanel yours;  ///< without faces whose half-edges do not lead around them
  RingPanel expected;
  std::size_t rim = 0;  ///< how many vertices are on it, counter-clockwise
  std::string picked;   ///< "e5", or "e5 and e7"

  bool empty() const { return rim == 0; }
};

/// The ring of faces that touch what is picked, and what became of it.
///
/// @param before  keeps all mesh rules
/// @param after   what the student's code left; any pointers
/// @param known   which of its vertices stand for the free labels; guessed if nobody knows
/// @param name    of what was picked
/// @return empty if the ring is no disc, or too large to be read
RingFigure figure_of_ring(const MeshDump& before, const Picked& picked, const Answer& answer,
                          const MeshDump& after, const std::optional<LabelMap>& known,
                          const std::string& name);

}  // namespace meshgrade
