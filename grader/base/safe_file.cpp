#include "grader/base/safe_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "grader/base/errors.h"
#include "grader/base/process.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// What goes wrong may come as late as with the last call, when the disk is full. Pipes and
/// devices have no disk: they cannot be synced (EINVAL).
bool write_to_disk(int fd, const std::string& text) {
  if (fd < 0) return false;
  bool ok = true;
  for (std::size_t done = 0; ok && done < text.size();) {
    const ssize_t size = ::write(fd, text.data() + done, text.size() - done);
    ok = size > 0 || (size < 0 && errno == EINTR);
    if (size > 0) done += static_cast<std::size_t>(size);
  }
  return ok && (::fsync(fd) == 0 || errno == EINVAL);
}

/// A name is in its folder only when the folder is on the disk. Some file systems cannot do it.
void sync_folder(const fs::path& folder) {
  const FileDescriptor fd(
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.get() >= 0) ::fsync(fd.get());
}

/// Why a file cannot be written, and what to do where the reason tells.
std::string explain(int reason) {
  switch (reason) {
    case EISDIR:
      return "it is a folder; name a file";
    case ENOENT:
      return std::string(std::strerror(reason)) + "; make the folder first";
    case ENOSPC:
    case EDQUOT:
      return std::string(std::strerror(reason)) + "; make room first";
    default:
      return std::strerror(reason);
  }
}

[[noreturn]] void refuse(const fs::path& file, int reason) {
  throw UserError(file.string() + ": cannot be written: " + explain(reason));
}

/// What a link leads to: a file stays where it is.
fs::path follow_links(const fs::path& file) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(file, error);
  return error ? file : target;
}

/// A new file of a name that nobody has. The umask decides its mode.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& folder) {
    static std::atomic<unsigned> counter{0};
    do {
      path_ = folder / (".meshgrade-" + std::to_string(::getpid()) + "-" +
                        std::to_string(counter++) + ".partial");
      fd_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (fd_ < 0 && errno == EEXIST);
    is_there_ = fd_ >= 0;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    const int reason = errno;
    if (fd_ >= 0) ::close(fd_);
    if (is_there_) ::unlink(path_.c_str());
    errno = reason;
  }

  int fd() const { return fd_; }

  bool become(const fs::path& target) {
    const int fd = std::exchange(fd_, -1);
    if (::close(fd) != 0 || ::rename(path_.c_str(), target.c_str()) != 0) return false;
    is_there_ = false;
    return true;
  }

 private:
  fs::path path_;
  int fd_ = -1;
  bool is_there_ = false;
};

/// The new file is as private as the old one, and belongs to the same person where that is
/// possible (root writes for somebody). Some file systems have one mode for all files.
bool take_over_mode(int fd, const struct stat& old) {
  if (::fchown(fd, old.st_uid, old.st_gid) != 0) errno = 0;  // then it belongs to the writer
  struct stat now {};
  if (::fstat(fd, &now) != 0) return false;
  return (now.st_mode & 0777U) == (old.st_mode & 0777U) ||
         ::fchmod(fd, old.st_mode & 0777U) == 0;
}

/// Whether the text is in the file now; else errno says why not.
bool replace(const fs::path& target, const std::string& text) {
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) {
    errno = EISDIR;
    return false;
  }
  // A folder that may be written to would let a read-only file be replaced.
  if (exists && ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) return false;
  TemporaryFile temporary(target.parent_path());
  if (temporary.fd() < 0) return false;
  if (exists && !take_over_mode(temporary.fd(), old)) return false;
  return write_to_disk(temporary.fd(), text) && temporary.become(target);
}

}  // namespace

bool is_stream(const fs::path& file) {
  std::error_code error;
  const std::string name = file.string();
  return name.starts_with("/dev/") || name.starts_with("/proc/") ||
         fs::is_other(fs::status(file, error));
}

void write_file_safely(const fs::path& file, const std::string& text) {
  if (is_stream(file)) {
    const FileDescriptor fd(::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
    if (!write_to_disk(fd.get(), text)) refuse(file, errno);
    return;
  }
  const fs::path target = follow_links(file);
  if (!replace(target, text)) refuse(file, errno);
  sync_folder(target.parent_path());
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw UserError(folder.string() + ": cannot be made: " + error.message());
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
