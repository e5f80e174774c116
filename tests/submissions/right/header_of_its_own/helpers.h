#pragma once

#include "meshedit/meshedit.h"

namespace helpers {

template <class Vector>
Vector lerp(const Vector& a, const Vector& b, double t) {
  return (1 - t) * a + t * b;
}

}  // namespace helpers
