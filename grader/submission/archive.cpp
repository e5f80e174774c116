#include "grader/submission/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <locale.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <set>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNotes = 8;

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

bool is_compressed(const fs::path& file) {
  static const std::set<std::string> endings{".gz", ".bz2", ".xz", ".zst"};
  return endings.count(lower(file.extension().string())) != 0;
}

bool is_package(const fs::path& file) {
  static const std::set<std::string> endings{".zip", ".tar",  ".7z",  ".tgz",
                                             ".tbz", ".tbz2", ".txz", ".tzst"};
  return endings.count(lower(file.extension().string())) != 0;
}

/// A single file that is compressed, and no archive of several: "flip.cpp.gz".
bool is_compressed_file(const fs::path& file) {
  return is_compressed(file) && !is_package(file.stem());
}

/// Names in archives are UTF-8; libarchive converts them to the locale of the thread.
class Utf8Locale {
 public:
  Utf8Locale() : locale_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (locale_ != nullptr) before_ = ::uselocale(locale_);
  }
  Utf8Locale(const Utf8Locale&) = delete;
  Utf8Locale& operator=(const Utf8Locale&) = delete;
  ~Utf8Locale() {
    if (locale_ == nullptr) return;
    ::uselocale(before_);
    ::freelocale(locale_);
  }

 private:
  locale_t locale_;
  locale_t before_ = nullptr;
};

struct CloseArchive {
  void operator()(archive* reader) const { ::archive_read_free(reader); }
};
using Reader = std::unique_ptr<archive, CloseArchive>;

class Unpacking {
 public:
  Unpacking(const fs::path& file, const fs::path& folder, const ArchiveLimits& limits,
            const std::function<Take(const fs::path&)>& choose)
      : file_(file), folder_(folder), limits_(limits), choose_(choose) {}

  std::vector<std::string> run() {
    open();
    archive_entry* entry = nullptr;
    for (;;) {
      const int status = ::archive_read_next_header(reader_.get(), &entry);
      if (status == ARCHIVE_EOF) break;
      // A warning is about a name or an attribute: the data can be read.
      if (status < ARCHIVE_WARN) refuse_damaged();
      if (is_compressed_file(file_) &&
          ::archive_filter_code(reader_.get(), 0) == ARCHIVE_FILTER_NONE) {
        refuse_damaged();
      }
      if (++entries_ > limits_.entries) {
        refuse("holds more than " + std::to_string(limits_.entries) + " entries");
      }
      take(entry);
    }
    if (left_out_ > kMostNotes) {
      notes_.push_back("and " + std::to_string(left_out_ - kMostNotes) +
                       " more entries of the archive are left out");
    }
    return std::move(notes_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw UserError(printable(file_.filename().string()) + ": " + what);
  }

  [[noreturn]] void refuse_damaged() const {
    // Before the first entry libarchive may not be asked: it does not know the format yet.
    if (entries_ > 0 && ::archive_read_has_encrypted_entries(reader_.get()) > 0) {
      refuse_encrypted();
    }
    const char* reason = ::archive_error_string(reader_.get());
    const std::string text = reason == nullptr ? "" : reason;
    if (text.find("ncrypt") != std::string::npos || text.find("rypto") != std::string::npos) {
      refuse_encrypted();
    }
    refuse("the archive is damaged or of another kind than its name says" +
           (text.empty() ? "" : " (" + printable(text) + ")"));
  }

  [[noreturn]] void refuse_encrypted() const {
    refuse("the archive is encrypted; it must be handed in without a password");
  }

  /// Only what libarchive reads itself: for other filters it would call programs.
  void open() {
    reader_.reset(::archive_read_new());
    archive* reader = reader_.get();
    if (reader == nullptr) throw GraderError("no memory to read an archive");
    ::archive_read_support_filter_gzip(reader);
    ::archive_read_support_filter_bzip2(reader);
    ::archive_read_support_filter_xz(reader);
    ::archive_read_support_filter_zstd(reader);
    if (is_compressed_file(file_)) {
      ::archive_read_support_format_raw(reader);
    } else {
      ::archive_read_support_format_zip(reader);
      ::archive_read_support_format_tar(reader);
      ::archive_read_support_format_7zip(reader);
    }
    constexpr std::size_t kBlock = 1U << 16U;
    if (::archive_read_open_filename(reader, file_.c_str(), kBlock) != ARCHIVE_OK) {
      refuse_damaged();
    }
  }

  void leave_out(const std::string& name, const std::string& why) {
    if (++left_out_ > kMostNotes) return;
    notes_.push_back(printable(name) + " is left out: " + why);
  }

  void take(archive_entry* entry) {
    if (::archive_entry_is_encrypted(entry) != 0) refuse_encrypted();
    const char* given = ::archive_entry_pathname(entry);
    std::string name = given == nullptr ? "" : given;
    if (is_compressed_file(file_)) name = file_.stem().string();
    std::replace(name.begin(), name.end(), '\\', '/');
    if (::archive_entry_filetype(entry) == AE_IFDIR) {
      make_folder(name);
      return;
    }
    const bool regular = ::archive_entry_filetype(entry) == AE_IFREG &&
                         ::archive_entry_hardlink(entry) == nullptr &&
                         ::archive_entry_symlink(entry) == nullptr;
    const std::string fault = regular ? fault_of(name) : "not an ordinary file";
    if (!fault.empty()) {
      leave_out(name, fault);
      read_data(-1, 0);
      return;
    }
    const fs::path inside = fs::path(name).lexically_normal();
    const Take wanted = choose_ ? choose_(inside) : Take::kWhole;
    if (wanted == Take::kNothing) {
      read_data(-1, 0);
      return;
    }
    write_file(inside, wanted == Take::kWhole ? limits_.file_bytes : 0);
  }

  /// An empty folder says that somebody handed in nothing, where each has one.
  void make_folder(const std::string& name) const {
    const fs::path inside = fs::path(name).lexically_normal();
    if (!fault_of(name).empty() || (choose_ && choose_(inside) == Take::kNothing)) return;
    std::error_code ignored;
    fs::create_directories(folder_ / inside, ignored);
  }

  /// What is wrong with a name; empty if nothing is.
  std::string fault_of(const std::string& name) const {
    if (name.empty() || name[0] == '/') return "its name is not one within the archive";
    std::size_t depth = 0;
    for (const fs::path& part : fs::path(name)) {
      if (part == "..") return "its name leads out of the archive";
      if (part.string().size() > 255) return "its name is too long";
      ++depth;
    }
    return depth > limits_.depth ? "it lies too deep in folders" : "";
  }

  void write_file(const fs::path& inside, std::uint64_t most) {
    const fs::path target = folder_ / inside;
    std::error_code error;
    fs::create_directories(target.parent_path(), error);
    const FileDescriptor out(
        error ? -1
              : ::open(target.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                       0600));
    if (out.get() < 0 && !error && errno != EEXIST && errno != EISDIR && errno != ENOTDIR) {
      throw GraderError(target.string() + ": cannot be written: " + std::strerror(errno));
    }
    if (out.get() < 0) leave_out(inside.string(), "something else in the archive has its name");
    if (!names_.insert(lower(inside.string())).second && out.get() >= 0) {
      notes_.push_back(printable(inside.string()) +
                       ": another name in the archive differs only in upper and lower case");
    }
    read_data(out.get(), out.get() < 0 ? 0 : most);
  }

  /// Reads the data of an entry to its end and writes the first `most` bytes of it.
  void read_data(int out, std::uint64_t most) {
    char buffer[1U << 16U];
    for (;;) {
      const la_ssize_t size = ::archive_read_data(reader_.get(), buffer, sizeof buffer);
      if (size == 0) return;
      if (size < ARCHIVE_WARN) refuse_damaged();
      if (size < 0) continue;
      bytes_ += static_cast<std::uint64_t>(size);
      if (bytes_ > limits_.bytes) {
        refuse("holds more than " + std::to_string(limits_.bytes >> 20U) +
               " MB when it is unpacked");
      }
      const std::size_t wanted = std::min<std::uint64_t>(most, static_cast<std::size_t>(size));
      most -= wanted;
      write_all(out, buffer, wanted);
    }
  }

  static void write_all(int out, const char* data, std::size_t size) {
    while (size > 0) {
      const ssize_t written = ::write(out, data, size);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) {
        throw GraderError(std::string("an archive cannot be unpacked: ") +
                          std::strerror(errno));
      }
      data += written;
      size -= static_cast<std::size_t>(written);
    }
  }

  const fs::path& file_;
  const fs::path& folder_;
  const ArchiveLimits& limits_;
  const std::function<Take(const fs::path&)>& choose_;
  Reader reader_;
  std::vector<std::string> notes_;
  std::set<std::string> names_;  ///< in lower case
  std::size_t left_out_ = 0;
  std::size_t entries_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace

bool is_archive_name(const fs::path& file) {
  return is_package(file) || is_compressed(file);
}

std::vector<std::string> unpack_archive(const fs::path& archive, const fs::path& folder,
                                        const ArchiveLimits& limits,
                                        const std::function<Take(const fs::path&)>& choose) {
  const Utf8Locale locale;
  return Unpacking(archive, folder, limits, choose).run();
}

}  // namespace meshgrade
