#pragma once

#include "../course.h"

#define PI 3.14159265358979323846  // NOLINT(modernize-macro-to-enum): homework expects a macro

namespace CGL {

inline double radians(double degrees) {
  return degrees * (PI / 180.0);
}

inline double degrees(double radians) {
  return radians * (180.0 / PI);
}

}  // namespace CGL
