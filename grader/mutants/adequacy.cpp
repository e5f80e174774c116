#include "grader/mutants/adequacy.h"

#include <algorithm>
#include <set>

#include "grader/base/random.h"

namespace meshgrade {
namespace {

/// `count` of the list, drawn with the seed and in their old order; all if `count` is 0.
template <class T>
std::vector<T> draw(std::vector<T> list, std::size_t count, Random random) {
  if (count == 0) return list;
  while (list.size() > count) {
    list.erase(list.begin() + random.below(static_cast<std::uint32_t>(list.size())));
  }
  return list;
}

std::vector<Mutant> find_mutants(const std::vector<Original>& originals,
                                 const AdequacyOptions& options) {
  std::vector<Mutant> mutants;
  for (const Original& original : originals) {
    for (const SourceFile& file : original.submission.sources) {
      if (!options.exercise.empty() && file.name != options.exercise + ".cpp") continue;
      for (Mutant& mutant : make_mutants(original, file))
        mutants.push_back(std::move(mutant));
    }
  }
  return mutants;
}

void compare_with_list(Adequacy& adequacy) {
  std::set<std::string> survivors;
  for (const MutantResult& result : adequacy.mutants) {
    if (result.fate == Fate::kSurvived) survivors.insert(result.mutant.id());
    if (result.fate != Fate::kGraderFailed) continue;
    adequacy.grader_errors.push_back(result.mutant.id() + ": " + result.verdict);
  }
  for (const std::string& id : survivors) {
    if (adequacy.reviewed.count(id) == 0) adequacy.unexplained.push_back(id);
  }
  // A sample says nothing about the mutants that are not in it.
  if (adequacy.options.mutants != 0 || !adequacy.options.exercise.empty()) return;
  for (const auto& [id, reason] : adequacy.reviewed) {
    if (survivors.count(id) == 0) adequacy.outdated.push_back(id);
  }
}

/// Where a time limit ends a case, how far it came is a matter of chance.
std::vector<Mutant> without_time_limit(const std::vector<MutantResult>& results) {
  std::vector<Mutant> mutants;
  for (const MutantResult& result : results) {
    if (result.fate == Fate::kKilled && result.verdict == verdict_name(Verdict::kFailed)) {
      mutants.push_back(result.mutant);
    }
  }
  return mutants;
}

}  // namespace

Share pointers_named(const Adequacy& adequacy) {
  Share share;
  for (const MutantResult& result : adequacy.mutants) {
    if (result.fate != Fate::kKilled || result.wrong_pointers.empty()) continue;
    ++share.whole;
    share.part += result.names_pointer() ? 1 : 0;
  }
  return share;
}

Share functions_named(const Adequacy& adequacy) {
  Share share;
  for (const MutantResult& result : adequacy.mutants) {
    if (result.fate != Fate::kKilled) continue;
    ++share.whole;
    share.part += result.names_function ? 1 : 0;
  }
  return share;
}

Adequacy measure_adequacy(const Assignment& assignment, const std::vector<Original>& originals,
                          const SurvivorList& reviewed, const AdequacyOptions& options,
                          const GradeFunction& grade, const JobProgress& progress) {
  Adequacy adequacy;
  adequacy.options = options;
  adequacy.reviewed = reviewed;
  for (const ExerciseRubric& rubric : assignment.exercises)
    adequacy.exercises.push_back(rubric.name);
  std::vector<Mutant> mutants = find_mutants(originals, options);
  adequacy.possible_mutants = mutants.size();
  mutants = draw(std::move(mutants), options.mutants, Random(options.seed, "mutants"));
  adequacy.mutants =
      grade_mutants(assignment, originals, mutants, grade, options.jobs, progress);
  compare_with_list(adequacy);
  adequacy.variants =
      grade_variants(originals, options.variants, options.seed, grade, options.jobs, progress);
  adequacy.determinism = compare_runs(assignment, originals,
                                      draw(without_time_limit(adequacy.mutants),
                                           options.repeated, Random(options.seed, "repeated")),
                                      grade, progress);
  return adequacy;
}

}  // namespace meshgrade
