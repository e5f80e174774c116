#include "grader/commands/kept_work.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

#include "grader/base/digest.h"
#include "grader/base/process_self.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// Many homes have a quota of a few gigabytes.
constexpr std::uint64_t kMostKept = 128U << 20U;

fs::path kept_folder() {
  const fs::path cache = cache_folder();
  return cache.empty() ? cache : cache / "kept";
}

/// What tells whether a file is still the same, without reading it.
void add_stamp(const fs::path& file, Digest& digest) {
  std::error_code ignored;
  const fs::path real = fs::canonical(file, ignored);
  digest.add(real.filename().string())
      .add(std::to_string(fs::file_size(real, ignored)))
      .add(std::to_string(fs::last_write_time(real, ignored).time_since_epoch().count()));
}

void add_stamps_below(const fs::path& folder, Digest& digest) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    add_stamp(file, digest);
}

std::string surroundings_of(const Home& home) {
  Digest digest;
  add_stamp(program_file(), digest);
  add_stamp(home.compiler, digest);
  add_stamps_below(home.kit, digest);
  add_stamps_below(home.include, digest);
  const Sandbox& sandbox = home.sandbox;
  digest.add(std::to_string(static_cast<int>(sandbox.layer)))
      .add(std::to_string(sandbox.filters_calls ? 1 : 0))
      .add(std::to_string(home.joins_files ? 1 : 0));
  return digest.hex();
}

/// Whether a submission can write to files of the user who runs the grader.
bool is_kept_from_submissions(const Sandbox& sandbox) {
  return sandbox.layer == Layer::kNamespaces || sandbox.layer == Layer::kOtherUser ||
         sandbox.bounds_files;
}

std::string why_nothing_is_kept(const Home& home) {
  if (!is_kept_from_submissions(home.sandbox))
    return "nothing is kept, since submissions could write to it here";
  if (kept_folder().empty()) return "nothing is kept: there is no home folder";
  return "nothing is kept: " + kept_folder().string() +
         " is no folder that you, and only you, can write to";
}

}  // namespace

fs::path cache_folder() {
  const char* xdg = std::getenv("XDG_CACHE_HOME");
  if (xdg != nullptr && fs::path(xdg).is_absolute()) return fs::path(xdg) / "meshgrade";
  if (::geteuid() == 0) return "/var/cache/meshgrade";
  const char* home = std::getenv("HOME");
  return home != nullptr && fs::path(home).is_absolute()
             ? fs::path(home) / ".cache" / "meshgrade"
             : fs::path();
}

void keep_work(Home& home) {
  if (!is_kept_from_submissions(home.sandbox)) return;
  auto kept = std::make_shared<KeptWork>(kept_folder(), kMostKept, surroundings_of(home));
  if (kept->files.works()) home.kept = std::move(kept);
}

std::string kept_work_text(const Home& home) {
  if (!home.kept) return why_nothing_is_kept(home);
  const KeptFiles::Usage usage = home.kept->files.usage();
  return plural(usage.files, "file") + ", " +
         number_text(static_cast<double>(usage.bytes) / 1e6, 3) + " MB, in " +
         home.kept->files.folder().string() + "; at most " + std::to_string(kMostKept >> 20U) +
         " MB, and safe to remove";
}

}  // namespace meshgrade
