#include "grader/package/archive_writer.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

struct EndWriter {
  void operator()(archive* writer) const { ::archive_write_free(writer); }
};
using Writer = std::unique_ptr<archive, EndWriter>;

struct EndEntry {
  void operator()(archive_entry* entry) const { ::archive_entry_free(entry); }
};

void require(bool fine, archive* writer, const fs::path& file) {
  if (fine) return;
  const char* why = ::archive_error_string(writer);
  throw UserError(file.string() +
                  ": cannot be written: " + (why == nullptr ? "unknown reason" : why));
}

la_ssize_t append(archive* /*writer*/, void* bytes, const void* data, std::size_t size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), size);
  return static_cast<la_ssize_t>(size);
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder));
  }
  std::sort(files.begin(), files.end());
  return files;
}

void add_file(archive* writer, const fs::path& folder, const fs::path& name,
              const fs::path& file) {
  const std::string text = read_whole_file(folder / name);
  const bool runs =
      (fs::status(folder / name).permissions() & fs::perms::owner_exec) != fs::perms::none;
  const std::unique_ptr<archive_entry, EndEntry> entry(::archive_entry_new());
  ::archive_entry_set_pathname(entry.get(), name.generic_string().c_str());
  ::archive_entry_set_filetype(entry.get(), AE_IFREG);
  ::archive_entry_set_perm(entry.get(), runs ? 0755 : 0644);
  ::archive_entry_set_size(entry.get(), static_cast<la_int64_t>(text.size()));
  // The earliest time that zip can hold.
  ::archive_entry_set_mtime(entry.get(), 315'532'800, 0);
  require(::archive_write_header(writer, entry.get()) == ARCHIVE_OK, writer, file);
  const la_ssize_t written = ::archive_write_data(writer, text.data(), text.size());
  require(written == static_cast<la_ssize_t>(text.size()), writer, file);
}

}  // namespace

void write_archive(const fs::path& folder, const fs::path& file) {
  const Writer writer(::archive_write_new());
  if (::archive_write_set_format_filter_by_ext(writer.get(), file.c_str()) != ARCHIVE_OK) {
    throw UserError(file.string() + ": the name must end with .zip, .tar or .tar.gz");
  }
  std::string bytes;
  ::archive_write_set_bytes_in_last_block(writer.get(), 1);  // no padding
  require(::archive_write_open(writer.get(), &bytes, nullptr, append, nullptr) == ARCHIVE_OK,
          writer.get(), file);
  for (const fs::path& name : files_in(folder))
    add_file(writer.get(), folder, name, file);
  require(::archive_write_close(writer.get()) == ARCHIVE_OK, writer.get(), file);
  write_file_safely(file, bytes);
}

}  // namespace meshgrade
