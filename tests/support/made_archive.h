#pragma once

// Archives for tests, also such as no honest tool would make.

#include <archive.h>
#include <archive_entry.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace meshgrade {

struct MadeEntry {
  std::string name;
  std::string text;
  unsigned type = AE_IFREG;
  std::string link = {};  ///< where a symbolic or hard link points to
  bool hard = false;
};

/// Writes an archive of the kind that its name says.
inline std::filesystem::path make_archive(const std::filesystem::path& file,
                                          const std::vector<MadeEntry>& entries,
                                          const std::string& password = "") {
  std::filesystem::create_directories(file.parent_path());
  archive* writer = ::archive_write_new();
  if (file.extension() == ".zst") {
    ::archive_write_set_format_gnutar(writer);
    ::archive_write_add_filter_zstd(writer);
  } else if (::archive_write_set_format_filter_by_ext(writer, file.c_str()) != ARCHIVE_OK) {
    throw std::runtime_error("no such kind of archive: " + file.string());
  }
  if (!password.empty()) {
    ::archive_write_set_options(writer, "zip:encryption=zipcrypt");
    ::archive_write_set_passphrase(writer, password.c_str());
  }
  ::archive_write_open_filename(writer, file.c_str());
  for (const MadeEntry& made : entries) {
    archive_entry* entry = ::archive_entry_new();
    ::archive_entry_set_pathname(entry, made.name.c_str());
    ::archive_entry_set_filetype(entry, made.type);
    ::archive_entry_set_perm(entry, 0644);
    ::archive_entry_set_size(entry, static_cast<la_int64_t>(made.text.size()));
    if (made.hard) ::archive_entry_set_hardlink(entry, made.link.c_str());
    if (made.type == AE_IFLNK) ::archive_entry_set_symlink(entry, made.link.c_str());
    if (::archive_write_header(writer, entry) < ARCHIVE_WARN) {
      throw std::runtime_error(::archive_error_string(writer));
    }
    ::archive_write_data(writer, made.text.data(), made.text.size());
    ::archive_entry_free(entry);
  }
  if (::archive_write_free(writer) != ARCHIVE_OK) {
    throw std::runtime_error("cannot write " + file.string());
  }
  return file;
}

}  // namespace meshgrade
