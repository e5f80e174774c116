#include "grader/build/build.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <thread>

#include "grader/base/errors.h"
#include "grader/build/added_members.h"
#include "grader/build/tool_words.h"
#include "grader/build/workshop.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// Calls `work(i)` for i = 0 .. count - 1 on all cores. Throws what one of them has thrown.
template <class Work>
void in_parallel(std::size_t count, Work work) {
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> failures(count);
  const auto take_turns = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  {
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < std::min(cores, count); ++i)
      helpers.emplace_back(take_turns);
    take_turns();
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

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

/// What connects a homework for Berkeley's skeleton with the worker. Where the student's header
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
  }
  return {};
}

class Builder {
 public:
  Builder(const Submission& submission, const Home& home, const Limits& limits, BuildKind kind)
      : submission_(submission),
        home_(home),
        limits_(limits),
        flags_("@" + (home.kit / flags_file(kind)).string()) {
    build_.sandbox = home.sandbox;
    if (kind == BuildKind::kSanitized) build_.logs.emplace();
  }

  Build build() {
    const std::size_t sources = submission_.sources.size();
    const std::vector<std::string> adapters = adapter_files(submission_.dialect);
    for (const SourceFile& source : submission_.sources)
      rests_.emplace_back(source.name, source.text);
    build_.files.resize(sources + adapters.size());
    make_workshops();
    in_parallel(build_.files.size(), [&](std::size_t i) {
      if (i < sources) {
        compile_source(i);
      } else {
        compile_adapter(i, adapters[i - sources]);
      }
    });
    link_all();
    build_.files.resize(sources);
    build_.worker = build_.folder.path() / kWorker;
    return std::move(build_);
  }

 private:
  static constexpr const char* kWorker = "worker";
  static constexpr const char* kMerged = "merged.o";
  static constexpr const char* kLocalised = "submission.o";
  static constexpr int kRounds = 8;

  /// One for each file, since several are compiled at a time.
  void make_workshops() {
    for (std::size_t i = 0; i < build_.files.size(); ++i) {
      workshops_.emplace_back(home_, limits_);
      for (const SourceFile& header : submission_.headers)
        workshops_[i].put(header.name, header.text);
    }
  }

  std::chrono::seconds time_limit() const {
    return std::chrono::seconds(limits_.compile_seconds);
  }

  /// Compiles a file in its workshop, and takes the object out of it.
  ProcessResult compile(std::size_t i, const std::string& file) const {
    const std::string object = object_name(i);
    std::vector<std::string> arguments{
        home_.compiler,
        flags_,
        "-I.",  // before the dropin folder, which has headers to stand in for the student's
        "-I" + home_.include.string(),
        "-ffile-prefix-map=" + workshops_[i].folder().string() + "=.",
        "-include",
        (home_.kit / "precompiled.h").string()};
    add_dialect(arguments);
    arguments.insert(arguments.end(), {"-c", file, "-o", object});
    ProcessResult result = workshops_[i].run(std::move(arguments), object);
    if (result.ok()) workshops_[i].hand_over(object, build_.folder.path());
    return result;
  }

  void add_dialect(std::vector<std::string>& arguments) const {
    if (submission_.dialect == Dialect::kMeshedit) return;
    const fs::path dropin = home_.include / "dropin";
    const bool old = submission_.dialect == Dialect::kCourse2017;
    arguments.insert(arguments.end(), {"-I" + dropin.string(), "-include",
                                       dropin / (old ? "course_2017.h" : "course.h")});
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
    file.name = submission_.sources[i].name;
    if (submission_.dialect == Dialect::kCourse2016) rests_[i].remove_members("BezierPatch");
    const auto end = std::chrono::steady_clock::now() + time_limit();
    ProcessResult result = compile_rest(i);
    file.messages = messages_of(result);
    if (submission_.dialect != Dialect::kMeshedit) {
      file.notes = explain_added_members(file.messages, submission_.course_headers);
    }
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
    workshops_[i].put(file.name, rests_[i].text());
    ProcessResult result = compile(i, file.name);
    if (is_dead_compiler(result)) result = compile(i, file.name);
    file.ok = result.ok();
    file.compiler_died = is_dead_compiler(result);
    file.left_out = file.ok ? rests_[i].left_out() : std::vector<LeftOut>();
    return result;
  }

  void compile_adapter(std::size_t i, const std::string& name) {
    BuiltFile& file = build_.files[i];
    file.name = "~" + name;  // no submitted file can have this name
    file.ok = compile(i, home_.include / "dropin" / name).ok();
  }

  std::string object_name(std::size_t i) const { return build_.files[i].name + ".o"; }

  /// Links the worker with these sources' objects. What the student's files define besides
  /// functions of the course is theirs alone: malloc, write or main cannot be replaced.
  ProcessResult link(const std::vector<std::size_t>& sources) const {
    const Workshop workshop(home_, limits_, build_.folder.path());
    std::vector<std::string> objects;
    for (std::size_t i : sources)
      objects.push_back(object_name(i));
    if (!objects.empty() && fs::exists(home_.kit / "merge.txt")) {
      ProcessResult merged = merge(workshop, objects);
      if (!merged.ok()) return merged;
      objects = {kLocalised};
    }
    std::vector<std::string> arguments{home_.compiler, flags_, "-no-pie", "-o", kWorker};
    arguments.insert(arguments.end(), objects.begin(), objects.end());
    arguments.push_back((home_.kit / "libmeshgrade_worker.a").string());
    return workshop.run(std::move(arguments), kWorker);
  }

  ProcessResult merge(const Workshop& workshop, const std::vector<std::string>& objects) const {
    std::vector<std::string> arguments{home_.compiler, "@" + (home_.kit / "merge.txt").string(),
                                       "-o", kMerged};
    arguments.insert(arguments.end(), objects.begin(), objects.end());
    ProcessResult merged = workshop.run(std::move(arguments), kMerged);
    if (!merged.ok()) return merged;
    return workshop.run(
        {"objcopy", "@" + (home_.kit / "localise.txt").string(), kMerged, kLocalised},
        kLocalised);
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

  /// Links all that compiled. If that fails, adds the objects one by one, until none is left
  /// that can be added: a file may need another one that comes later.
  void link_all() {
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < build_.files.size(); ++i) {
      if (build_.files[i].ok) waiting.push_back(i);
    }
    ProcessResult first = link(waiting);
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
  std::string flags_;
  Build build_;
  std::vector<LeavingOut> rests_;  ///< of the sources
  std::vector<Workshop> workshops_;
};

}  // namespace

const BuiltFile* Build::find(const std::string& name) const {
  for (const BuiltFile& file : files) {
    if (file.name == name) return &file;
  }
  return nullptr;
}

Build build_submission(const Submission& submission, const Home& home, const Limits& limits,
                       BuildKind kind) {
  return Builder(submission, home, limits, kind).build();
}

}  // namespace meshgrade
