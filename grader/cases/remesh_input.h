#pragma once

// What the exercise isotropic_remeshing asks, as it goes to the worker. C++17.

#include <cstdint>
#include <string>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// A factor for which no edge is split.
constexpr double kNeverLonger = 1e3;

/// meshedit::RemeshParameters.
struct RemeshSettings {
  double longer = kNeverLonger;
  double shorter = 0.0;  ///< then no edge is collapsed
  double step = 0.2;
  std::uint32_t outer = 1;
  std::uint32_t smoothing = 0;

  /// Whether edges may be split or collapsed.
  bool resizes() const { return longer < kNeverLonger || shorter > 0.0; }

  template <class Wire>
  void transfer(Wire& wire) {
    wire(longer, shorter, step, outer, smoothing);
  }
};

struct RemeshInput {
  std::string mesh_name;
  PolygonMesh mesh;  ///< triangles
  std::uint32_t anchor_turns = 0;
  RemeshSettings settings;
  /// Whether edge lengths and valences must be no worse afterwards. Only where they are bad.
  std::uint32_t improves = 0;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(mesh_name, mesh, anchor_turns, settings, improves);
  }
};

}  // namespace meshgrade
