#pragma once

#include <string>

#include "grader/view/mesh_session.h"

namespace meshgrade {

/// With more half-edges than this a mesh goes to the page as bytes: as JSON it would take
/// seconds to write and to read. A closed mesh of 20,000 triangles has as many.
constexpr std::size_t kMostHalfedgesAsJson = 60'000;

/// What goes to the page.
struct PageAnswer {
  std::string body;
  const char* type;  ///< of its content
};

/// What the page shows of a session: JSON as view_json makes it, or, with a large mesh, JSON
/// and bytes. Those are, all little-endian:
///
///   "MGM1", the size of the JSON as u32, the JSON, spaces up to a multiple of 8, the arrays
///
/// In the JSON a mesh is then {at, h, v, e, f, b}: where in the arrays it begins, and how many
/// it has of each kind. Its arrays are those of report/mesh_json, in this order: p as f64; h,
/// v, e, f and b as u32; and zeros up to a multiple of 8.
PageAnswer answer_for_page(const MeshSession& session);

}  // namespace meshgrade
