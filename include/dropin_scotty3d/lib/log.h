#pragma once

// Messages for people, and assertions that stop the program where they fail.

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "meshedit/fault.h"

namespace meshedit {
namespace detail {
namespace scotty3d {

inline void print_line(const char* level, const std::string& format, std::va_list arguments) {
  std::printf("[%s] ", level);
  std::vprintf(format.c_str(), arguments);
  std::printf("\n");
}

}  // namespace scotty3d
}  // namespace detail
}  // namespace meshedit

// Formats are those of printf.
#define SCOTTY3D_PRINTS(name)                                         \
  inline void name(std::string format, ...) {                         \
    std::va_list arguments;                                           \
    va_start(arguments, format);                                      \
    meshedit::detail::scotty3d::print_line(#name, format, arguments); \
    va_end(arguments);                                                \
  }
SCOTTY3D_PRINTS(log)
SCOTTY3D_PRINTS(info)
SCOTTY3D_PRINTS(warn)
#undef SCOTTY3D_PRINTS

/// Says so and ends the program.
[[noreturn]] inline void die(std::string format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  meshedit::detail::scotty3d::print_line("die", format, arguments);
  va_end(arguments);
  std::exit(1);
}

#undef assert
#define assert(...) \
  ((__VA_ARGS__)    \
       ? (void)0    \
       : meshedit::detail::raise_fault(meshedit::FaultKind::kFailedAssertion, #__VA_ARGS__))
