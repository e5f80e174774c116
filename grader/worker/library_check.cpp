// The student's files are compiled with the standard library's own checks: an index out of
// range, the first element of nothing. What the library calls when one fails is defined here,
// so that the failure becomes the ending of a task, with its place, as a misused handle does.
// Linked before the library's own definition, which would print and abort. C++17.

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "grader/worker/child.h"

namespace {

[[noreturn]] void refuse(const std::string& what) {
  meshgrade::library_check_failed(what);
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

}  // namespace

// The names are the library's, so they cannot be ours.
// NOLINTBEGIN(cert-dcl58-cpp,bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp,readability-identifier-naming)
#if defined(__GLIBCXX__)
namespace std {
[[noreturn]] void __glibcxx_assert_fail(const char* /*file*/, int /*line*/,
                                        const char* function, const char* condition) noexcept {
  refuse(std::string(condition) + " in " + function);
}
}  // namespace std
#elif defined(_LIBCPP_VERSION) && _LIBCPP_VERSION >= 160000
// The library lets programs define this one.
void std::__libcpp_verbose_abort(const char* format, ...)
#ifdef _LIBCPP_VERBOSE_ABORT_NOEXCEPT
    _LIBCPP_VERBOSE_ABORT_NOEXCEPT
#endif
{
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  refuse(text);
}
#endif
// NOLINTEND(cert-dcl58-cpp,bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp,readability-identifier-naming)
