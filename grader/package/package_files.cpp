#include "grader/package/package_files.h"

#include <algorithm>
#include <system_error>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

void require_written(const fs::path& target, const std::error_code& error) {
  if (!error) return;
  throw UserError(target.string() + ": cannot be written: " + error.message());
}

void copy_one(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  require_written(to.parent_path(), error);
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  require_written(to, error);
}

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

bool is_one_of(const fs::path& file, const std::vector<fs::path>& others) {
  return std::any_of(others.begin(), others.end(),
                     [&](const fs::path& other) { return is_same(file, other); });
}

void copy_folder(const fs::path& from, const fs::path& to,
                 const std::vector<fs::path>& secrets) {
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    if (entry.is_symlink() || fs::exists(entry.path() / "CMakeCache.txt")) continue;
    const fs::path target = to / entry.path().filename();
    if (entry.is_directory()) {
      copy_folder(entry.path(), target, secrets);
    } else if (entry.is_regular_file() && !is_one_of(entry.path(), secrets)) {
      copy_one(entry.path(), target);
    }
  }
}

}  // namespace

std::vector<PackagePart> grader_parts(const fs::path& project) {
  std::vector<PackagePart> parts;
  for (const char* part :
       {"LICENSE", "meshgrade", "include", "grader", "meshes", "viewer/dist"})
    parts.push_back({part, part});
  if (!fs::exists(project / "CMakeLists.txt")) return parts;
  for (const char* part : {"CMakeLists.txt", "CMakePresets.json", ".gitignore", "cmake"})
    parts.push_back({part, part});
  return parts;
}

void make_package_folder(const fs::path& target) {
  std::error_code error;
  fs::create_directories(target, error);
  require_written(target, error);
  if (!fs::is_empty(target, error)) {
    throw UserError(target.string() + " is not empty; name a new folder with -o");
  }
}

std::vector<PackagePart> assignment_parts(const Assignment& assignment, const fs::path& file,
                                          const std::string& to, bool hidden) {
  std::vector<PackagePart> parts{{file.string(), to}};
  for (const OwnMesh& mesh : assignment.own_meshes()) {
    if (mesh.hidden && !hidden) continue;
    parts.push_back({mesh.file.string(), (fs::path(to).parent_path() / mesh.name).string()});
  }
  return parts;
}

void copy_parts(const fs::path& project, const std::vector<PackagePart>& parts,
                const fs::path& target, const std::vector<fs::path>& secrets) {
  for (const PackagePart& part : parts) {
    const fs::path from = project / part.from;
    if (fs::is_directory(from)) {
      copy_folder(from, target / part.to, secrets);
    } else if (fs::is_regular_file(from)) {
      copy_one(from, target / part.to);
    } else {
      throw UserError(from.string() + " is missing: this is no whole copy of Meshgrade");
    }
  }
}

}  // namespace meshgrade
