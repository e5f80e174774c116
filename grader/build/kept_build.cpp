#include "grader/build/kept_build.h"

#include <algorithm>
#include <fstream>

#include "grader/base/digest.h"
#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/base/wire.h"
#include "grader/build/reach.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWorker = "worker";

void add(const std::vector<SourceFile>& files, Digest& digest) {
  digest.add(std::to_string(files.size()));
  for (const SourceFile& file : files)
    digest.add(file.name).add(file.text);
}

/// What every object of a submission may depend on beside its own source.
Digest digest_of_surroundings(const Submission& submission, const Home& home, BuildKind kind) {
  Digest digest;
  digest.add(home.kept->surroundings).add(std::to_string(static_cast<int>(kind)));
  digest.add(std::to_string(static_cast<int>(submission.dialect)));
  add(submission.headers, digest);
  return digest;
}

std::string identity_of_all(const BuildOrigin& origin) {
  Digest digest;
  digest.add(origin.surroundings).add("all");
  add(origin.sources, digest);
  return digest.hex();
}

struct KeptBuild {
  std::string worker;
  std::vector<BuiltFile> files;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(worker, files);
  }
};

}  // namespace

BuildOrigin origin_of(const Submission& submission, const Home& home, const Limits& limits,
                      BuildKind kind) {
  if (!home.kept) return {};
  Digest digest = digest_of_surroundings(submission, home, kind);
  digest.add("build").add(std::to_string(limits.compile_seconds));
  digest.add(std::to_string(limits.compile_memory_mb)).add(std::to_string(limits.object_mb));
  add(submission.course_headers, digest);
  // Members that a homework adds to the course's elements may be told from any of its files;
  // and what a header of its own holds may call what no source names.
  const bool is_divisible =
      submission.dialect == Dialect::kMeshedit && submission.headers.empty();
  return {digest.hex(), submission.sources, is_divisible};
}

std::string identity_of(const BuildOrigin& origin, const std::vector<std::string>& functions) {
  if (!origin.is_divisible || functions.empty()) return identity_of_all(origin);
  Digest digest;
  digest.add(origin.surroundings);
  for (std::size_t i : files_reached(origin.sources, functions))
    digest.add(origin.sources[i].name).add(origin.sources[i].text);
  return digest.hex();
}

std::optional<Build> find_kept_build(const Home& home, const BuildOrigin& origin,
                                     BuildKind kind) {
  if (!home.kept) return std::nullopt;
  const std::optional<std::string> bytes = home.kept->files.find(identity_of_all(origin));
  if (!bytes) return std::nullopt;
  Build build;
  try {
    KeptBuild found = from_wire<KeptBuild>(*bytes);
    build.files = std::move(found.files);
    build.worker = build.folder.path() / kWorker;
    std::ofstream stream(build.worker, std::ios::binary);
    stream << found.worker;
    if (!stream.flush()) throw GraderError("cannot write " + build.worker.string());
  } catch (const WireError&) {
    return std::nullopt;
  }
  fs::permissions(build.worker, fs::perms(0755));
  build.sandbox = home.sandbox;
  if (kind == BuildKind::kSanitized) build.logs.emplace();
  build.kept = home.kept;
  build.times = home.times;
  build.origin = origin;
  return build;
}

void keep_build(const Build& build) {
  const auto is_sure = [](const BuiltFile& file) { return file.ok && !file.compiler_died; };
  if (!build.kept || !std::all_of(build.files.begin(), build.files.end(), is_sure)) return;
  build.kept->files.keep(identity_of_all(build.origin),
                         to_wire(KeptBuild{read_whole_file(build.worker), build.files}));
}

KeptObjects::KeptObjects(const Submission& submission, const Home& home, BuildKind kind)
    : kept_(home.kept) {
  if (kept_) surroundings_ = digest_of_surroundings(submission, home, kind).hex();
}

std::string KeptObjects::digest_of(const SourceFile& file) const {
  return Digest().add(surroundings_).add("file").add(file.name).add(file.text).hex();
}

std::string KeptObjects::key_of(const std::vector<SourceFile>& unit,
                                const std::vector<SourceFile>& spliced) const {
  Digest digest;
  digest.add(surroundings_).add("unit");
  add(unit, digest);
  add(spliced, digest);
  return digest.hex();
}

std::optional<CompiledUnit> KeptObjects::find(const std::vector<SourceFile>& unit,
                                              const std::vector<SourceFile>& spliced) const {
  if (!kept_) return std::nullopt;
  try {
    const std::optional<std::string> bytes = kept_->files.find(key_of(unit, spliced));
    if (bytes) return from_wire<CompiledUnit>(*bytes);
  } catch (const WireError&) {  // of another version: as if it were not there
  }
  return std::nullopt;
}

void KeptObjects::keep(const std::vector<SourceFile>& unit,
                       const std::vector<SourceFile>& spliced,
                       const CompiledUnit& compiled) const {
  if (!kept_) return;
  std::vector<std::string> digests;
  for (const SourceFile& file : unit)
    digests.push_back(digest_of(file));
  kept_->files.keep(key_of(unit, spliced), to_wire(compiled));
  for (const std::string& digest : digests)
    kept_->files.keep(digest, to_wire(digests));
}

std::vector<std::string> KeptObjects::unit_of(const SourceFile& file) const {
  if (!kept_) return {};
  try {
    const std::optional<std::string> bytes = kept_->files.find(digest_of(file));
    if (bytes) return from_wire<std::vector<std::string>>(*bytes);
  } catch (const WireError&) {
  }
  return {};
}

}  // namespace meshgrade
