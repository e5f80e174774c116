#pragma once

#include <ostream>

namespace meshedit {

/// Red, green and blue, from 0 to 1 each, and in some years how opaque it is.
class Color {
 public:
  float r;
  float g;
  float b;
  float a;

  // NOLINTNEXTLINE(google-explicit-constructor): the course's is implicit
  Color(float red = 0.0F, float green = 0.0F, float blue = 0.0F, float alpha = 1.0F)
      : r(red), g(green), b(blue), a(alpha) {}

  Color operator+(const Color& c) const { return {r + c.r, g + c.g, b + c.b, a}; }
  Color operator*(const Color& c) const { return {r * c.r, g * c.g, b * c.b, a}; }
  Color operator*(float s) const { return {r * s, g * s, b * s, a}; }
  Color& operator+=(const Color& c) { return *this = *this + c; }
  Color& operator*=(const Color& c) { return *this = *this * c; }
  Color& operator*=(float s) { return *this = *this * s; }
  bool operator==(const Color& c) const { return r == c.r && g == c.g && b == c.b && a == c.a; }
  bool operator!=(const Color& c) const { return !(*this == c); }

  static const Color White;
  static const Color Black;
};

inline const Color Color::White{1.0F, 1.0F, 1.0F};
inline const Color Color::Black{};

inline Color operator*(float s, const Color& c) {
  return c * s;
}

inline std::ostream& operator<<(std::ostream& out, const Color& c) {
  return out << "(" << c.r << "," << c.g << "," << c.b << "," << c.a << ")";
}

}  // namespace meshedit
