#include "grader/base/kept_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <system_error>
#include <vector>

#include "grader/base/digest.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDigestSize = 64;
constexpr const char* kUnfinished = ".part";

/// Stands in front of the bytes: a file that was cut off, changed or renamed does not have it.
std::string seal_of(const std::string& key, const std::string& bytes) {
  return Digest().add(key).add(bytes).hex();
}

struct KeptFile {
  fs::path path;
  std::uint64_t size = 0;
  fs::file_time_type used;
};

std::vector<KeptFile> files_in(const fs::path& folder) {
  std::vector<KeptFile> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    std::error_code gone;  // another program may clean up as well
    const KeptFile file{entry.path(), entry.file_size(gone), entry.last_write_time(gone)};
    if (!gone) files.push_back(file);
  }
  return files;
}

}  // namespace

bool is_only_mine(const fs::path& folder) {
  struct stat found {};
  return ::lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) &&
         found.st_uid == ::geteuid() && (found.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

bool make_own_folder(const fs::path& folder) {
  std::error_code error;
  if (folder.empty()) return false;
  fs::create_directories(folder, error);
  return is_only_mine(folder) && ::access(folder.c_str(), W_OK | X_OK) == 0;
}

KeptFiles::KeptFiles(fs::path folder, std::uint64_t most)
    : folder_(std::move(folder)),
      most_(most),
      works_(make_own_folder(folder_)),
      written_(most) {
  std::error_code ignored;
  if (works_) fs::permissions(folder_, fs::perms::owner_all, ignored);
}

std::optional<std::string> KeptFiles::find(const std::string& key) const {
  if (!works_) return std::nullopt;
  const fs::path file = folder_ / sha256(key);
  std::error_code ignored;
  const std::uintmax_t size = fs::file_size(file, ignored);
  if (ignored) return std::nullopt;
  std::string all(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(all.data(), static_cast<std::streamsize>(all.size()))) return std::nullopt;
  const std::string bytes = all.substr(std::min(kDigestSize, all.size()));
  if (all.compare(0, kDigestSize, seal_of(key, bytes)) != 0) {
    fs::remove(file, ignored);
    return std::nullopt;
  }
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  return bytes;
}

void KeptFiles::keep(const std::string& key, const std::string& bytes) const {
  if (!works_) return;
  if (written_.fetch_add(bytes.size()) >= most_ / 4) {
    written_ = 0;
    remove_oldest();
  }
  static std::atomic<unsigned> number{0};
  const fs::path file = folder_ / sha256(key);
  const fs::path part = file.string() + "." + std::to_string(::getpid()) + "." +
                        std::to_string(number++) + kUnfinished;
  std::error_code ignored;
  {
    std::ofstream stream(part, std::ios::binary);
    stream << seal_of(key, bytes) << bytes;
    if (!stream.flush()) {
      stream.close();
      fs::remove(part, ignored);
      return;
    }
  }
  fs::rename(part, file, ignored);
  if (ignored) fs::remove(part, ignored);
}

KeptFiles::Usage KeptFiles::usage() const {
  Usage usage;
  if (!works_) return usage;
  for (const KeptFile& file : files_in(folder_)) {
    ++usage.files;
    usage.bytes += file.size;
  }
  return usage;
}

/// Down to half, so that it need not be done again soon.
void KeptFiles::remove_oldest() const {
  std::vector<KeptFile> files = files_in(folder_);
  std::uint64_t bytes = 0;
  for (const KeptFile& file : files)
    bytes += file.size;
  if (bytes <= most_) return;
  std::sort(files.begin(), files.end(),
            [](const KeptFile& a, const KeptFile& b) { return a.used < b.used; });
  for (const KeptFile& file : files) {
    if (bytes <= most_ / 2) return;
    std::error_code ignored;
    fs::remove(file.path, ignored);
    bytes -= file.size;
  }
}

}  // namespace meshgrade
