#pragma once

// Vectors and matrices of floats, by the names of the course.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>

#include "log.h"

#define EPS_F 0.00001f
#define PI_F 3.14159265358979323846264338327950288f
#define PI_D 3.14159265358979323846264338327950288
#define Radians(v) ((v) * (PI_F / 180.0f))
#define Degrees(v) ((v) * (180.0f / PI_F))

#include "mat4.h"
#include "vec2.h"
#include "vec3.h"
#include "vec4.h"

inline float sign(float x) {
  return x > 0.0f ? 1.0f : x < 0.0f ? -1.0f : 0.0f;
}

/// From `a`, for t = 0, to `b`, for t = 1.
template <typename T>
T lerp(T a, T b, float t) {
  return a * (1.0f - t) + b * t;
}

template <typename T>
T clamp(T x, T low, T high) {
  return std::min(std::max(x, low), high);
}

inline float clamp(float x, float low, float high) {
  return std::min(std::max(x, low), high);
}
