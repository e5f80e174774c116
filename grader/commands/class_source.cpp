#include "grader/commands/class_source.h"

#include <CLI/CLI.hpp>

#include "grader/base/text.h"
#include "grader/submission/archive.h"

namespace meshgrade {
namespace {

/// A class hands in more than a student does.
constexpr ArchiveLimits kClassArchive{std::uint64_t{16} << 30U, std::uint64_t{1} << 30U,
                                      2'000'000, 40};

}  // namespace

ClassSource open_class(const std::filesystem::path& submissions, const RosterOptions& options) {
  ClassSource source;
  std::vector<std::string> notes;
  const bool archive =
      !std::filesystem::is_directory(submissions) && is_archive_name(submissions);
  if (archive && std::filesystem::exists(submissions)) {
    source.unpacked.emplace();
    notes = unpack_archive(submissions, source.unpacked->path(), kClassArchive);
  }
  source.roster = read_roster(source.unpacked ? source.unpacked->path() : submissions, options);
  for (const std::string& note : notes)
    source.roster.left_out.push_back({printable(submissions.filename().string()), note});
  return source;
}

void add_roster_options(CLI::App& command, RosterOptions& options) {
  std::vector<std::string> names;
  for (const Layout& layout : layouts())
    names.emplace_back(layout.name);
  command.add_option(
      "--layout", options.layout,
      "How the folder is arranged: " + join(names, ", ") + "; found out if not given");
  command.add_option("--part", options.assignment,
                     "Which assignment, where the folder holds several (nbgrader)");
}

}  // namespace meshgrade
