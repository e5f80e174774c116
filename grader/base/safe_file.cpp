#include "grader/base/safe_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "grader/base/errors.h"
#include "grader/base/process.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// What goes wrong may come as late as with the last call, when the disk is full. Pipes and
/// devices have no disk: they cannot be synced (EINVAL).
bool write_to_disk(const fs::path& file, const std::string& text) {
  const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (fd < 0) return false;
  bool ok = true;
  for (std::size_t done = 0; ok && done < text.size();) {
    const ssize_t size = ::write(fd, text.data() + done, text.size() - done);
    ok = size > 0 || (size < 0 && errno == EINTR);
    if (size > 0) done += static_cast<std::size_t>(size);
  }
  ok = ok && (::fsync(fd) == 0 || errno == EINVAL);
  return ::close(fd) == 0 && ok;
}

/// A name is in its folder only when the folder is on the disk. Some file systems cannot do it.
void sync_folder(const fs::path& folder) {
  const FileDescriptor fd(
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.get() >= 0) ::fsync(fd.get());
}

[[noreturn]] void refuse(const fs::path& file) {
  throw UserError(file.string() + ": cannot be written: " + std::strerror(errno) +
                  "; is the folder there, with room left?");
}

/// A pipe or a device, such as /dev/stdout: to be written to, and never to be replaced.
bool is_stream(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return fs::is_other(status);
}

/// What a link leads to: a file stays where it is.
fs::path follow_links(const fs::path& file) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(file, error);
  return error ? file : target;
}

}  // namespace

void write_file_safely(const fs::path& file, const std::string& text) {
  if (is_stream(file)) {
    if (!write_to_disk(file, text)) refuse(file);
    return;
  }
  const fs::path target = follow_links(file);
  fs::path temporary = target;
  temporary += ".partial";
  if (!write_to_disk(temporary, text) || ::rename(temporary.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    std::error_code ignored;
    fs::remove(temporary, ignored);
    errno = reason;
    refuse(file);
  }
  sync_folder(target.parent_path());
}

std::string read_whole_file(const fs::path& file) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  if (!stream.is_open() || stream.bad() || fs::is_directory(file, error)) {
    throw UserError(file.string() + ": cannot be read");
  }
  return bytes.str();
}

}  // namespace meshgrade
