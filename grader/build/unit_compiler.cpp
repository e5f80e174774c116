#include "grader/build/unit_compiler.h"

#include <algorithm>
#include <fstream>
#include <map>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/build/joining.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

using Unit = std::vector<std::size_t>;

constexpr const char* kProbe = "probe.cpp";
constexpr const char* kJoined = "~joined.cpp";

const char* flags_file(BuildKind kind) {
  switch (kind) {
    case BuildKind::kSanitized:
      return "flags_sanitize.txt";
    case BuildKind::kDebug:
      return "flags_debug.txt";
    case BuildKind::kGrading:
      break;
  }
  return "flags.txt";
}

void write_object(const fs::path& file, const std::string& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream << bytes;
  if (!stream.flush()) throw GraderError("cannot write " + file.string());
}

bool is_in_any(std::size_t file, const std::vector<Unit>& units) {
  return std::any_of(units.begin(), units.end(), [&](const Unit& unit) {
    return std::find(unit.begin(), unit.end(), file) != unit.end();
  });
}

/// What comes behind the elements, where they have members of the student's.
void add_later(std::vector<std::string>& arguments) {
  arguments.insert(arguments.end(), {"-include", MemberSplice::kLater});
}

}  // namespace

UnitCompiler::UnitCompiler(const Submission& submission, const Home& home, const Limits& limits,
                           BuildKind kind, const MemberSplice& splice, fs::path objects)
    : submission_(submission),
      home_(home),
      limits_(limits),
      splice_(splice),
      flags_("@" + (home.kit / flags_file(kind)).string()),
      objects_(std::move(objects)),
      kept_(submission, home, kind) {}

ProcessResult UnitCompiler::compile(const std::vector<SourceFile>& unit,
                                    const std::string& object) const {
  return run(unit, unit.size() == 1 ? unit[0].name : kJoined, object);
}

ProcessResult UnitCompiler::compile_adapter(const std::string& name,
                                            const std::string& object) const {
  return run({{name, ""}}, dropin() / name.substr(1), object);
}

ProcessResult UnitCompiler::compile_driver(const std::string& object) const {
  return kept_or({{"~driver", ""}}, object, [&] { return compile_driver_anew(object); });
}

ProcessResult UnitCompiler::compile_driver_anew(const std::string& object) const {
  const StageTimer timer(home_.times.get(), "compile");
  const Workshop workshop(home_, limits_);
  put_headers(workshop);
  const fs::path driver = home_.kit / "driver";
  ProcessResult result = workshop.run(
      {home_.compiler, "@" + (home_.kit / "flags.txt").string(), "-DMESHEDIT_ADDED", "-I.",
       "-I" + home_.include.string(), "-I" + driver.string(), "-c",
       driver / "grader" / "worker" / "mesh_driver.cpp", "-o", object},
      object);
  if (result.ok()) workshop.hand_over(object, objects_);
  return result;
}

ProcessResult UnitCompiler::try_headers() const {
  const Workshop workshop(home_, limits_);
  put_headers(workshop);
  workshop.put(kProbe, "");
  std::vector<std::string> arguments{home_.compiler, flags_};
  add_headers(arguments);
  if (adds_later()) add_later(arguments);
  arguments.insert(arguments.end(), {"-c", kProbe, "-o", "probe.o"});
  return workshop.run(std::move(arguments), "probe.o");
}

std::vector<Unit> UnitCompiler::divide(const std::vector<SourceFile>& sources,
                                       const Unit& joined) const {
  std::vector<Unit> units = units_of_before(sources, joined);
  Unit changed;
  Unit neighbours;  // of what has changed: they were in a unit with it
  for (std::size_t i : joined) {
    if (is_in_any(i, units)) continue;
    (kept_.unit_of(sources[i]).empty() ? changed : neighbours).push_back(i);
  }
  for (Unit& unit : share_out(changed, cores_of(home_)))
    units.push_back(std::move(unit));
  if (!neighbours.empty()) units.push_back(neighbours);
  return units;
}

/// Units of an earlier build whose files are all here and unchanged.
std::vector<Unit> UnitCompiler::units_of_before(const std::vector<SourceFile>& sources,
                                                const Unit& joined) const {
  std::map<std::string, std::size_t> place;
  for (std::size_t i : joined)
    place[kept_.digest_of(sources[i])] = i;
  std::vector<Unit> units;
  for (std::size_t i : joined) {
    if (is_in_any(i, units)) continue;
    Unit unit;
    for (const std::string& digest : kept_.unit_of(sources[i])) {
      const auto found = place.find(digest);
      if (found == place.end()) {
        unit.clear();
        break;
      }
      unit.push_back(found->second);
    }
    if (!unit.empty()) units.push_back(std::move(unit));
  }
  return units;
}

void UnitCompiler::put_headers(const Workshop& workshop) const {
  for (const SourceFile& header : submission_.headers)
    workshop.put(header.name, header.text);
  if (splice_.empty()) return;
  for (const SourceFile& header : splice_.files())
    workshop.put(header.name, header.text);
}

/// The folders to look in, and what comes before every source.
void UnitCompiler::add_headers(std::vector<std::string>& arguments) const {
  // First what was handed in: the dropin folder has headers to stand in for the student's.
  arguments.insert(arguments.end(), {"-I.", "-I" + home_.include.string(), "-include"});
  if (splice_.empty() || is_scotty3d(submission_.dialect)) {
    arguments.push_back(home_.kit / "precompiled.h");
    if (!splice_.empty()) arguments.emplace_back("-DSCOTTY3D_ADDED");
  } else {
    arguments.insert(arguments.end(), {home_.include / "meshedit" / "meshedit.h",
                                       "-DMESHEDIT_ADDED", "-DMESHEDIT_ADDED_FUNCTIONS"});
  }
  if (submission_.dialect == Dialect::kMeshedit) return;
  // In the course's project these lie beside the student's folder: "../geometry/halfedge.h".
  if (is_scotty3d(submission_.dialect)) {
    arguments.push_back("-I" + (dropin() / "geometry").string());
    arguments.push_back("-I" + (home_.include / "dropin_scotty3d" / "lib").string());
  }
  const bool old = submission_.dialect == Dialect::kCourse2017;
  arguments.insert(arguments.end(), {"-I" + dropin().string(), "-include",
                                     dropin() / (old ? "course_2017.h" : "course.h")});
}

/// Whether members that the student added need a file of their own, behind all headers.
bool UnitCompiler::adds_later() const {
  return !splice_.empty() && !is_scotty3d(submission_.dialect);
}

/// Where the headers by the names of the course are.
fs::path UnitCompiler::dropin() const {
  const char* folder = submission_.dialect == Dialect::kScotty3d       ? "dropin_scotty3d"
                       : submission_.dialect == Dialect::kScotty3d2020 ? "dropin_scotty3d_2020"
                                                                       : "dropin";
  return home_.include / folder;
}

/// @param file  of the unit, or another one that is all of them
ProcessResult UnitCompiler::run(const std::vector<SourceFile>& unit, const std::string& file,
                                const std::string& object) const {
  return kept_or(unit, object, [&] { return run_anew(unit, file, object); });
}

/// What was kept of a unit, compiled with the same headers and what is spliced into them, or
/// what `compile` makes of it.
template <typename Compile>
ProcessResult UnitCompiler::kept_or(const std::vector<SourceFile>& unit,
                                    const std::string& object, const Compile& compile) const {
  const std::vector<SourceFile> spliced =
      splice_.empty() ? std::vector<SourceFile>() : splice_.files();
  if (const auto found = kept_.find(unit, spliced)) {
    write_object(objects_ / object, found->object);
    ProcessResult result;
    result.output = found->messages;
    return result;
  }
  ProcessResult result = compile();
  if (result.ok() && home_.kept)
    kept_.keep(unit, spliced, {result.output, read_whole_file(objects_ / object)});
  return result;
}

ProcessResult UnitCompiler::run_anew(const std::vector<SourceFile>& unit,
                                     const std::string& file, const std::string& object) const {
  const StageTimer timer(home_.times.get(), "compile");
  const Workshop workshop(home_, limits_);
  put_headers(workshop);
  std::vector<std::string> names;
  for (const SourceFile& source : unit) {
    names.push_back(source.name);
    workshop.put(source.name, source.text);
  }
  if (file == kJoined) workshop.put(kJoined, joined_source(names));
  std::vector<std::string> arguments{home_.compiler, flags_,
                                     "-ffile-prefix-map=" + workshop.folder().string() + "=."};
  add_headers(arguments);
  const bool is_adapter = fs::path(file).is_absolute();
  if (adds_later() && !is_adapter) add_later(arguments);
  arguments.insert(arguments.end(), {"-c", file, "-o", object});
  ProcessResult result = workshop.run(std::move(arguments), object);
  if (result.ok()) workshop.hand_over(object, objects_);
  return result;
}

}  // namespace meshgrade
