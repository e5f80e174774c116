#include "grader/build/build.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "grader/base/errors.h"
#include "grader/base/parallel.h"
#include "grader/build/added_members.h"
#include "grader/build/joining.h"
#include "grader/build/kept_build.h"
#include "grader/build/link_worker.h"
#include "grader/build/member_splice.h"
#include "grader/build/tool_words.h"
#include "grader/build/unit_compiler.h"
#include "grader/submission/course_files.h"
#include "grader/submission/scotty3d_files.h"

namespace meshgrade {
namespace {

/// What connects a homework for another skeleton with the worker. Where the student's header
/// does not compile, neither do they, and the functions behind them are "not implemented".
std::vector<std::string> adapter_files(Dialect dialect) {
  switch (dialect) {
    case Dialect::kMeshedit:
      break;
    case Dialect::kCourse2016:
    case Dialect::kCourse2020:
      return {"adapter.cpp"};
    case Dialect::kCourse2017:
      return {"adapter.cpp", "adapter_2017.cpp"};
    case Dialect::kScotty3d:
      return {"adapter.cpp", "halfedge_mesh.cpp"};
    case Dialect::kScotty3d2020:
      return {"adapter.cpp", "halfedge_mesh.cpp", "debug_data.cpp"};
  }
  return {};
}

class Builder {
 public:
  Builder(const Submission& submission, const Home& home, const Limits& limits, BuildKind kind)
      : submission_(submission),
        home_(home),
        limits_(limits),
        compiler_(submission, home, limits, kind, splice_, build_.folder.path()) {
    build_.sandbox = home.sandbox;
    if (kind == BuildKind::kSanitized) build_.logs.emplace();
  }

  Build build() {
    splice_ = MemberSplice(submission_);
    do {
      settle_splice();
      compile_all();
    } while (is_driver_missing() || add_members_from_use());
    note_members();
    link_all();
    build_.files.resize(submission_.sources.size());
    build_.worker = build_.folder.path() / kWorker;
    return std::move(build_);
  }

 private:
  static constexpr const char* kWorker = "worker";
  static constexpr const char* kDriver = "driver.o";
  static constexpr int kRounds = 8;

  using Unit = std::vector<std::size_t>;  ///< places of files that are compiled as one

  void compile_all() {
    begin_files();
    const std::vector<Unit> units = divide();
    const std::size_t drivers = has_driver() ? 1 : 0;
    in_parallel(cores_of(home_), units.size() + drivers, [&](std::size_t i) {
      if (i < units.size()) {
        compile_unit(units[i]);
      } else {
        driver_ok_ = compiler_.compile_driver(kDriver).ok();
      }
    });
  }

  /// The sources, ready to be compiled, and behind them the adapters.
  void begin_files() {
    rests_.clear();
    build_.files.clear();
    for (const SourceFile& source : submission_.sources) {
      rests_.emplace_back(source.name, source.text);
      LeavingOut& rest = rests_.back();
      if (submission_.dialect == Dialect::kCourse2016) rest.remove_members("BezierPatch");
      if (is_berkeleys(submission_.dialect)) rest.mark_unwritten(graded_functions());
      if (is_scotty3d(submission_.dialect)) {
        rest.mark_refusing(scotty3d_graded_functions(submission_.dialect));
        // The grader's own takes down what it is given.
        rest.remove_function("Halfedge_Mesh::catmark_subdivide_helper");
      }
      build_.files.emplace_back().name = source.name;
    }
    for (const std::string& adapter : adapter_files(submission_.dialect))
      build_.files.emplace_back().name = "~" + adapter;  // no submitted file can have this name
    objects_.assign(build_.files.size(), "");
  }

  /// What is compiled at a time: units of what can be joined, the rest alone.
  std::vector<Unit> divide() const {
    std::vector<SourceFile> sources;
    for (std::size_t i = 0; i < rests_.size(); ++i)
      sources.push_back(rest_of(i));
    const Unit joined = home_.joins_files ? joinable(sources, submission_.headers) : Unit();
    std::vector<Unit> units = compiler_.divide(sources, joined);
    for (std::size_t i = 0; i < build_.files.size(); ++i) {
      if (std::find(joined.begin(), joined.end(), i) == joined.end()) units.push_back({i});
    }
    return units;
  }

  SourceFile rest_of(std::size_t i) const { return {build_.files[i].name, rests_[i].text()}; }

  void compile_unit(const Unit& unit) {
    if (unit.size() > 1 && compile_joined(unit)) return;
    for (std::size_t i : unit)
      i < rests_.size() ? compile_source(i) : compile_adapter(i);
  }

  /// @return false if the compiler has anything to say: then each file has to hear it alone
  bool compile_joined(const Unit& unit) {
    const std::string object = "~" + std::to_string(unit.front()) + ".o";
    std::vector<SourceFile> sources;
    for (std::size_t i : unit)
      sources.push_back(rest_of(i));
    const ProcessResult result = compiler_.compile(sources, object);
    if (!result.ok() || !result.output.empty()) return false;
    for (std::size_t i : unit) {
      build_.files[i].ok = true;
      objects_[i] = object;
    }
    return true;
  }

  /// Takes out of the splice what does not compile.
  void settle_splice() {
    for (int round = 0; !splice_.empty(); ++round) {
      const ProcessResult result = compiler_.try_headers();
      if (result.ok()) return;
      if (round == kRounds || result.stopped()) {
        splice_.drop_all("they do not compile");
      } else {
        splice_.drop_blamed(result.output);
      }
    }
  }

  /// Whether the worker's own part is compiled anew: it sees the classes that the student has
  /// added to.
  bool has_driver() const { return !splice_.empty() && !is_scotty3d(submission_.dialect); }

  /// Whether what is not the student's compiles with the members that were added.
  bool is_own_part_fine() const {
    if (has_driver()) return driver_ok_;
    return std::all_of(build_.files.begin() + static_cast<std::ptrdiff_t>(rests_.size()),
                       build_.files.end(), [](const BuiltFile& file) { return file.ok; });
  }

  /// @return whether there are new members, and everything has to be compiled again
  bool add_members_from_use() {
    if (!is_berkeleys(submission_.dialect)) return false;
    std::string messages;
    for (const BuiltFile& file : build_.files)
      messages += file.messages + "\n";
    return splice_.add_from_use(unknown_members(messages), submission_);
  }

  /// Says what became of added members, and which functions cannot be judged for them.
  void note_members() {
    if (submission_.dialect == Dialect::kMeshedit || rests_.empty()) return;
    build_.files[0].notes = splice_.notes();
    for (std::size_t i = 0; i < rests_.size(); ++i) {
      for (LeftOut& left : build_.files[i].left_out)
        tell_missing_member(left, build_.files[i]);
    }
  }

  /// A member that nobody declares is the student's mistake if the header is here to show it,
  /// or if it is written nearly like one of the course's.
  void tell_missing_member(LeftOut& left, BuiltFile& file) const {
    const MemberUse use = unknown_member(left.message);
    if (use.empty()) return;
    const std::string place = place_of_member(submission_.course_headers, use.name);
    const auto& headers = submission_.course_headers;
    const bool is_here = std::any_of(headers.begin(), headers.end(), [](const SourceFile& h) {
      return h.name == "halfEdgeMesh.h" || h.name == "halfedge.h";
    });
    const bool missing = !is_here && !MemberSplice::is_slip(use);
    left.not_judged = splice_.is_declared(use) || !place.empty() || missing;
    if (!left.not_judged) return;
    file.notes.push_back(
        file.name + ":" + std::to_string(left.line) + " uses " + use.class_name +
        "::" + use.name +
        (place.empty() ? ", which the course's " + use.class_name +
                             " does not have: hand in the header that adds it; until then "
                       : ", a member that was added to the course's header (" + place +
                             ") and could not be taken over: ") +
        left.function + " is not judged");
  }

  std::chrono::seconds time_limit() const {
    return std::chrono::seconds(limits_.compile_seconds);
  }

  /// @return whether everything has to be compiled again, without the members
  bool is_driver_missing() {
    if (splice_.empty() || is_own_part_fine()) return false;
    splice_.drop_all("the grader's own part does not compile with them");
    return true;
  }

  std::string messages_of(const ProcessResult& result) const {
    const std::string said = complaints(result, limits_);
    return is_dead_compiler(result)
               ? "the compiler itself broke, twice: this is no fault of the code\n" + said
               : said;
  }

  /// Leaves out functions that do not compile, until the rest does or none is left to blame.
  void compile_source(std::size_t i) {
    BuiltFile& file = build_.files[i];
    const auto end = std::chrono::steady_clock::now() + time_limit();
    ProcessResult result = compile_rest(i);
    file.messages = messages_of(result);
    for (int round = 0; round < kRounds && !result.ok(); ++round) {
      if (std::chrono::steady_clock::now() > end || file.compiler_died) break;
      if (!rests_[i].learn_from(result.output)) break;
      result = compile_rest(i);
    }
    if (result.ok()) file.warnings = warnings_in(result.output);
    file.messages = without_warnings(file.messages);
  }

  /// Compiles what is left of a source.
  ProcessResult compile_rest(std::size_t i) {
    BuiltFile& file = build_.files[i];
    objects_[i] = file.name + ".o";
    ProcessResult result = compiler_.compile({rest_of(i)}, objects_[i]);
    if (is_dead_compiler(result)) result = compiler_.compile({rest_of(i)}, objects_[i]);
    file.ok = result.ok();
    file.compiler_died = is_dead_compiler(result);
    file.left_out = file.ok ? rests_[i].left_out() : std::vector<LeftOut>();
    return result;
  }

  void compile_adapter(std::size_t i) {
    BuiltFile& file = build_.files[i];
    objects_[i] = file.name + ".o";
    const ProcessResult result = compiler_.compile_adapter(file.name, objects_[i]);
    file.ok = result.ok();
    if (result.timed_out && splice_.empty() && submission_.headers.empty()) {
      throw GraderError("compiling " + file.name.substr(1) +
                        ", a part of the grader's own, took longer than " +
                        std::to_string(limits_.compile_seconds) +
                        " s: this machine is very busy, or slow. Try again, or raise "
                        "compile_seconds in the assignment");
    }
  }

  /// Links the worker with these sources' objects.
  ProcessResult link(const std::vector<std::size_t>& sources) const {
    const StageTimer timer(home_.times.get(), "link");
    const Workshop workshop(home_, limits_, build_.folder.path());
    std::vector<std::string> objects;
    for (std::size_t i : sources) {
      if (std::find(objects.begin(), objects.end(), objects_[i]) == objects.end())
        objects.push_back(objects_[i]);
    }
    return link_worker(workshop, home_, compiler_.flags(),
                       {objects, has_driver() ? kDriver : "", kWorker});
  }

  /// Leaves out functions that call what is defined nowhere.
  /// @return false if there is none, or its file does not compile without it
  bool leave_out_callers(const ProcessResult& linked) {
    const std::string& messages = linked.output;
    bool found = false;
    for (std::size_t i = 0; i < rests_.size(); ++i) {
      if (!build_.files[i].ok || !rests_[i].learn_from(messages)) continue;
      build_.files[i].messages = messages;
      if (!compile_rest(i).ok()) return false;
      found = true;
    }
    return found;
  }

  std::vector<std::size_t> compiled() const {
    std::vector<std::size_t> files;
    for (std::size_t i = 0; i < build_.files.size(); ++i) {
      if (build_.files[i].ok) files.push_back(i);
    }
    return files;
  }

  /// Compiles alone what was compiled as a part of something. @return whether there was any
  bool take_apart() {
    Unit joined;
    for (std::size_t i = 0; i < rests_.size(); ++i) {
      if (objects_[i] != build_.files[i].name + ".o") joined.push_back(i);
    }
    in_parallel(cores_of(home_), joined.size(),
                [&](std::size_t i) { compile_source(joined[i]); });
    return !joined.empty();
  }

  /// Links all that compiled. If that fails, adds the objects one by one, until none is left
  /// that can be added: a file may need another one that comes later.
  void link_all() {
    std::vector<std::size_t> waiting = compiled();
    ProcessResult first = link(waiting);
    if (!first.ok() && take_apart()) {
      waiting = compiled();
      first = link(waiting);
    }
    for (int round = 0; round < kRounds && !first.ok() && leave_out_callers(first); ++round) {
      first = link(waiting);
    }
    if (first.ok()) return;
    std::vector<std::size_t> taken;
    for (bool progress = true; progress;) {
      progress = false;
      for (std::size_t i : std::vector<std::size_t>(waiting)) {
        taken.push_back(i);
        const ProcessResult result = link(taken);
        if (result.ok()) {
          progress = true;
          waiting.erase(std::find(waiting.begin(), waiting.end(), i));
        } else {
          taken.pop_back();
          const std::string why = explain_link_error(result.output);
          build_.files[i].messages = (why.empty() ? "" : why + "\n") + result.output;
        }
      }
    }
    for (std::size_t i : waiting)
      build_.files[i].ok = build_.files[i].linked = false;
    const ProcessResult last = link(taken);
    if (!last.ok()) throw GraderError("the worker cannot be linked: " + last.output);
  }

  const Submission& submission_;
  const Home& home_;
  const Limits& limits_;
  Build build_;
  MemberSplice splice_;
  UnitCompiler compiler_;
  bool driver_ok_ = false;
  std::vector<LeavingOut> rests_;     ///< of the sources
  std::vector<std::string> objects_;  ///< in which each file is; several may be in one
};

}  // namespace

std::size_t cores_of(const Home& home) {
  return home.cores > 0 ? home.cores : std::max(1U, std::thread::hardware_concurrency());
}

const BuiltFile* Build::find(const std::string& name) const {
  for (const BuiltFile& file : files) {
    if (file.name == name) return &file;
  }
  return nullptr;
}

Build build_submission(const Submission& submission, const Home& home, const Limits& limits,
                       BuildKind kind) {
  BuildOrigin origin = origin_of(submission, home, limits, kind);
  if (auto kept = find_kept_build(home, origin, kind)) return std::move(*kept);
  Build build = Builder(submission, home, limits, kind).build();
  build.kept = home.kept;
  build.times = home.times;
  build.origin = std::move(origin);
  keep_build(build);
  return build;
}

}  // namespace meshgrade
