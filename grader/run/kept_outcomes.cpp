#include "grader/run/kept_outcomes.h"

#include <algorithm>
#include <csignal>

#include "grader/base/digest.h"
#include "grader/base/wire.h"
#include "grader/build/kept_build.h"

namespace meshgrade {
namespace {

struct KeptOutcomes {
  std::vector<Outcome> outcomes;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(outcomes);
  }
};

/// Signals that a program brings on itself. Others may come from outside.
bool is_own_fault(int signal) {
  return signal == SIGSEGV || signal == SIGBUS || signal == SIGABRT || signal == SIGFPE ||
         signal == SIGILL || signal == SIGTRAP;
}

/// Whether it would come out the same on a busier machine.
bool is_sure(const Outcome& outcome) {
  if (outcome.lost) return false;
  switch (outcome.ending) {
    case Ending::kDone:
    case Ending::kFault:
    case Ending::kExit:
    case Ending::kException:
    case Ending::kLibraryCheck:
      return true;
    case Ending::kSignal:
      return is_own_fault(outcome.code);
    default:
      return false;
  }
}

}  // namespace

std::string identity_of_run(const Build& build, const std::vector<std::string>& functions,
                            const std::string& tasks, const Limits& limits) {
  // The sanitizers write what they find beside the outcomes.
  if (!build.kept || build.logs) return {};
  return Digest()
      .add(identity_of(build.origin, functions))
      .add("run")
      .add(std::to_string(limits.run_seconds))
      .add(std::to_string(limits.processes))
      .add(std::to_string(limits.open_files))
      .add(tasks)
      .hex();
}

std::optional<std::vector<Outcome>> find_kept_outcomes(const Build& build,
                                                       const std::string& identity) {
  if (identity.empty()) return std::nullopt;
  const std::optional<std::string> bytes = build.kept->files.find(identity);
  if (!bytes) return std::nullopt;
  try {
    return from_wire<KeptOutcomes>(*bytes).outcomes;
  } catch (const WireError&) {  // of another version: as if it were not there
    return std::nullopt;
  }
}

void keep_outcomes(const Build& build, const std::string& identity,
                   const std::vector<Outcome>& outcomes) {
  if (identity.empty() || !std::all_of(outcomes.begin(), outcomes.end(), is_sure)) return;
  build.kept->files.keep(identity, to_wire(KeptOutcomes{outcomes}));
}

}  // namespace meshgrade
