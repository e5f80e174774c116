#include "grader/files/file_bytes.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 31U;

}  // namespace

void refuse_file(const std::filesystem::path& file, const std::string& place,
                 const std::string& what) {
  throw UserError(file.string() + (place.empty() ? "" : ":" + place) + ": " + what);
}

std::string read_bytes(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) refuse_file(file, "", "no such file; check the path");
  if (std::filesystem::is_directory(status)) {
    refuse_file(file, "", "is a folder; name a file in it");
  }
  if (!std::filesystem::is_regular_file(status)) refuse_file(file, "", "is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) refuse_file(file, "", "cannot be read: " + error.message());
  if (size == 0) refuse_file(file, "", "is empty; export or download it again");
  if (size > kLargestFile) refuse_file(file, "", "is larger than 2 GiB");

  std::string bytes(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size))) {
    refuse_file(file, "", "cannot be read; check its permissions");
  }
  return bytes;
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::string in_quotes(std::string_view words, std::size_t longest) {
  std::string text(words.substr(0, longest));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + text + (words.size() > longest ? "...'" : "'");
}

void check_corner(const std::filesystem::path& file, const std::string& place, std::size_t face,
                  std::uint32_t vertex, std::size_t n_vertices, unsigned first_number) {
  if (vertex < n_vertices) return;
  refuse_file(file, place,
              "face f" + std::to_string(face) + " asks for vertex " +
                  std::to_string(std::uint64_t{vertex} + first_number) + ", but the " +
                  std::to_string(n_vertices) + " vertices are numbered from " +
                  std::to_string(first_number));
}

void check_polygon(const std::filesystem::path& file, std::size_t face,
                   const std::vector<std::uint32_t>& corners, std::size_t n_vertices) {
  const std::string name = "face f" + std::to_string(face);
  if (corners.size() < 3) {
    refuse_file(
        file, "",
        name + " has " + std::to_string(corners.size()) + " corners; a face needs at least 3");
  }
  for (const std::uint32_t v : corners)
    check_corner(file, "", face, v, n_vertices, 0);
  std::vector<std::uint32_t> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    refuse_file(file, "",
                name + " has vertex " + std::to_string(*twice) +
                    " at two corners; the corners of a face must differ");
  }
}

}  // namespace meshgrade
