#include "grader/worker/result_file.h"

#include <unistd.h>

#include <cerrno>

namespace meshgrade {
namespace {

bool write_at(int file, const char* data, std::size_t size, std::uint64_t offset) {
  while (size > 0) {
    const ssize_t written = ::pwrite(file, data, size, static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    data += written;
    size -= static_cast<std::size_t>(written);
    offset += static_cast<std::uint64_t>(written);
  }
  return true;
}

}  // namespace

bool append_frame(int file, SharedState& shared, const std::string& bytes,
                  std::uint64_t limit) {
  const std::uint64_t start = shared.result_size;
  const std::uint64_t length = bytes.size();
  const std::uint64_t end = start + sizeof length + length;
  if (end > limit) return false;
  if (!write_at(file, reinterpret_cast<const char*>(&length), sizeof length, start) ||
      !write_at(file, bytes.data(), bytes.size(), start + sizeof length)) {
    return false;
  }
  shared.result_size = end;
  return true;
}

}  // namespace meshgrade
