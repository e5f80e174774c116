#pragma once

// The steps of isotropic remeshing as far as all right solutions agree on them, whatever order
// they go in, and whether they go on until there is nothing left to do. On closed and open
// meshes of triangles without double edges.

#include <optional>
#include <utility>
#include <vector>

#include "grader/operations/face_lists.h"

namespace meshgrade {

/// By its ends, the smaller one first.
using EdgeEnds = std::pair<Label, Label>;

std::vector<EdgeEnds> edges_of(const FaceLists& lists);
double edge_length(const FaceLists& lists, const EdgeEnds& edge);
double mean_edge_length(const FaceLists& lists);
bool is_closed(const FaceLists& lists);

/// An inner edge, and the two corners opposite to it.
struct FlipPlace {
  Label a, b;
  Label c;  ///< of the triangle that has the side from a to b
  Label d;
};

/// The place of an edge; nothing on a boundary.
std::optional<FlipPlace> flip_place(const Surface& surface, const FaceLists& lists,
                                    const EdgeEnds& edge);

/// By how much a flip lowers the sum of |n - 6|. An even number.
int flip_gain(const Surface& surface, const FlipPlace& place);

/// Turns an edge to one that is not there yet.
void flip(FaceLists& lists, const FlipPlace& place);

/// The sum of |n - 6| over all vertices.
int valence_deviation(const FaceLists& lists);

/// After all edges longer than `longer` times the mean length were split, and then all that are
/// shorter than `shorter` times it were collapsed that may be.
/// @return nothing if solutions may differ: a length is hardly more or less than the limit, two
///         edges to split or to collapse lie side by side, halves are still too long, what is
///         left has an edge too short again, or a collapse may be refused
std::optional<FaceLists> surely_resized(const FaceLists& lists, double longer, double shorter);

/// The first half of it, and the second one.
/// @param mean  length of the edges before they were split; that of `split` may be taken as
/// well
std::optional<FaceLists> surely_split(const FaceLists& lists, double longer);
std::optional<FaceLists> surely_collapsed(const FaceLists& split, double mean, double shorter);

/// After all edges were flipped where that pays.
/// @return nothing if solutions may differ: the mesh is open, or a flip changes what another
///         one is worth, or would double an edge
std::optional<FaceLists> surely_flipped(const FaceLists& lists);

}  // namespace meshgrade
