#include "grader/base/process_self.h"

#include <cstdint>
#include <system_error>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

namespace meshgrade {

std::filesystem::path program_file() {
#ifdef __APPLE__
  char name[4096];
  std::uint32_t size = sizeof name;
  return ::_NSGetExecutablePath(name, &size) == 0 ? std::filesystem::path(name)
                                                  : std::filesystem::path();
#else
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error);
#endif
}

}  // namespace meshgrade
