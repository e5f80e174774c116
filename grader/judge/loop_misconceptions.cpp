#include "grader/judge/loop_misconceptions.h"

namespace meshgrade {
namespace {

/// About the points of edges.
Misconceptions new_vertex_misconceptions() {
  return {
      {"edge-midpoints",
       "new vertices lie in the middle of their edges: they need the weights 3/8 and 1/8"},
      {"edge-weights-swapped", "3/8 and 1/8 are swapped: 3/8 is for the ends of the edge"},
      {"new-position-not-set",
       "all new vertices are at (0, 0, 0): the point of the edge is not handed on to the new "
       "vertex. splitEdge returns that vertex: set its newPosition"},
      {"integer-division",
       "weights such as 3/8 are divided as whole numbers and become 0: write 3.0 / 8.0"},
      {"edges-from-moved",
       "edge points are computed from old vertices that have moved already"},
  };
}

/// About when and where old vertices get their new positions.
Misconceptions copying_misconceptions() {
  return {
      {"last-not-copied",
       "the last vertex is left out: it alone has not got its new position. Look at where the "
       "loop that copies newPosition to position ends"},
      {"first-not-copied",
       "the first vertex is left out: it alone has not got its new position. Look at where the "
       "loop that copies newPosition to position begins"},
      {"not-moved",
       "the triangles are right, but no point has moved: newPosition is never computed, or "
       "never copied"},
      {"old-not-copied",
       "old vertices stay where they were: their newPosition is not copied to position"},
      {"new-neighbours",
       "old vertices are computed after the splits, when their neighbours are the new "
       "vertices: compute them before"},
      {"moved-in-place",
       "old vertices are moved one after the other, so that later ones see neighbours that "
       "have moved already: compute all, then move"},
  };
}

/// About the weights of old vertices.
Misconceptions weight_misconceptions() {
  return {
      {"integer-weight",
       "old vertices stay where they were: the weight u is divided as a whole number and "
       "becomes 0: write 3.0 / (8.0 * n)"},
      {"integer-three-sixteenths",
       "old vertices with three neighbours stay where they were: 3/16 is divided as whole "
       "numbers and becomes 0: write 3.0 / 16.0"},
      {"neighbours-twice",
       "every neighbour is counted twice, so that the weights add up to more than 1: each "
       "neighbour lies in two triangles"},
      {"boundary-vertices-counted",
       "on the boundary, all neighbours that lie on a boundary are counted: only the two along "
       "the boundary are, over edges that lie on it. With a third one the weights add up to "
       "9/8"},
      {"tuned-for-regularity",
       "these are weights tuned for regularity, as MeshLab's \"Enhance regularity\" has them: "
       "Loop's or Warren's are asked"},
      {"tuned-for-continuity",
       "these are weights tuned for continuity, as MeshLab's \"Enhance continuity\" has them: "
       "Loop's or Warren's are asked"},
      {"same-weight-everywhere", "u = 3/16 is for valence 3 only: otherwise it is 3 / (8 n)"},
      {"no-valence-three",
       "u = 3 / (8 n) is used for valence 3, too, so that 5/8 is the own weight everywhere: "
       "for valence 3 it is 3/16"},
      {"own-weight-wrong", "the old vertex's own weight is 1 - u: it must be 1 - n u"},
      {"boundary-like-inside",
       "vertices on the boundary are moved like those inside: 3/4 of their own position and "
       "1/8 of each of the two neighbours on the boundary"},
      {"rules-mixed", "two rules are mixed: use one everywhere"},
      {"other-rule", "another published rule is asked for"},
  };
}

}  // namespace

const Misconceptions& position_misconceptions() {
  static const Misconceptions known = [] {
    Misconceptions all = new_vertex_misconceptions();
    for (const Misconceptions& more : {weight_misconceptions(), copying_misconceptions()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return known;
}

const Misconceptions& loop_misconceptions() {
  static const Misconceptions known = [] {
    Misconceptions all = flip_misconceptions();
    all.insert(all.end(), position_misconceptions().begin(), position_misconceptions().end());
    return all;
  }();
  return known;
}

}  // namespace meshgrade
