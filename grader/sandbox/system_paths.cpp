#include "grader/sandbox/system_paths.h"

#include <unistd.h>

#include <algorithm>

#include <cstdlib>
#include <sstream>

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLibraries[] = {
    "/lib",       "/lib32",     "/lib64",      "/libx32",        "/usr/lib",
    "/usr/lib32", "/usr/lib64", "/usr/libx32", "/usr/local/lib", "/usr/local/lib64"};
constexpr const char* kTools[] = {
    "/bin",           "/usr/bin",           "/usr/libexec",      "/usr/include",
    "/usr/local/bin", "/usr/local/include", "/usr/local/libexec"};
constexpr const char* kSettings[] = {"/etc/ld.so.cache", "/etc/alternatives"};

bool exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

}  // namespace

std::vector<fs::path> system_paths(bool compiles) {
  std::vector<fs::path> paths;
  const auto add = [&](const char* path) {
    if (exists(path)) paths.emplace_back(path);
  };
  for (const char* path : kLibraries)
    add(path);
  for (const char* path : kSettings)
    add(path);
  if (compiles) {
    for (const char* path : kTools)
      add(path);
  }
  return paths;
}

std::vector<fs::path> loaders() {
  std::vector<fs::path> found;
  for (const char* folder : {"/lib", "/lib64"}) {
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
      if (it->path().filename().string().rfind("ld-", 0) == 0) found.push_back(it->path());
    }
  }
  return found;
}

std::vector<fs::path> harmless_devices() {
  return {"/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom"};
}

fs::path unusual_folder_of(const std::string& program) {
  std::error_code error;
  const fs::path found = fs::canonical(
      program.find('/') == std::string::npos ? find_program(program) : fs::path(program),
      error);
  if (error) return {};
  for (const fs::path& usual : system_paths(true)) {
    if (is_below(found, usual)) return {};
  }
  return found.parent_path().parent_path();  // of bin/, next to which its libraries are
}

bool is_open_to_others(const fs::path& path) {
  const auto lets_others = [](const fs::path& place, fs::perms what) {
    return (fs::status(place).permissions() & what) != fs::perms::none;
  };
  const bool folder = fs::is_directory(path);
  if (!lets_others(path, folder ? fs::perms::others_exec : fs::perms::others_read))
    return false;
  for (fs::path above = fs::canonical(path).parent_path(); above != above.root_path();
       above = above.parent_path()) {
    if (!lets_others(above, fs::perms::others_exec)) return false;
  }
  return true;
}

fs::path find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    fs::path candidate = fs::path(folder) / name;
    if (::access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return {};
}

}  // namespace meshgrade
