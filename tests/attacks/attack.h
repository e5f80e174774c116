#pragma once

// Every attack includes this header. Its submission answers rightly (or, with WRONG_ANSWER,
// not), and calls attack() when it is asked for the first normal. paths.h is written by the
// test:
//
//   SECRET_FILE   a file of the instructor's, which holds SECRET
//   VICTIM_FILE   a file of the instructor's, which anybody may write as far as its mode goes
//   LEFT_BEHIND   the beginning of the name of a file that must not be there afterwards

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "meshedit/meshedit.h"
#include "paths.h"

void attack();

/// For what must fail: the test looks for this word.
inline void expect_refusal(const char* what, bool done) {
  if (done) std::printf("BREACH: %s\n", what);
}

namespace meshedit {

Vector3D Vertex::normal() const {
  static const bool attacked = (::attack(), true);
  static_cast<void>(attacked);
#ifdef WRONG_ANSWER
  return {0, 0, 0};
#endif
  Vector3D sum;
  HalfedgeCIter h = halfedge();
  do {
    if (!h->isBoundary()) {
      const Vector3D b = h->next()->vertex()->position;
      const Vector3D c = h->next()->next()->vertex()->position;
      sum += cross(b - position, c - position);
    }
    h = h->twin()->next();
  } while (h != halfedge());
  return sum.unit();
}

}  // namespace meshedit
