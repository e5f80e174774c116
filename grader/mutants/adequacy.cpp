#include "grader/mutants/adequacy.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "grader/base/random.h"

namespace meshgrade {
namespace {

/// At most `count` of the list, drawn with the seed and in their old order.
template <class T>
std::vector<T> draw(std::vector<T> list, std::size_t count, Random random) {
  while (list.size() > count) {
    list.erase(list.begin() + random.below(static_cast<std::uint32_t>(list.size())));
  }
  return list;
}

std::vector<Mutant> find_mutants(const std::vector<Original>& originals) {
  std::vector<Mutant> mutants;
  for (const Original& original : originals) {
    for (const SourceFile& file : original.submission.sources) {
      for (Mutant& mutant : make_mutants(original, file))
        mutants.push_back(std::move(mutant));
    }
  }
  return mutants;
}

std::set<std::string> ids_of(const std::vector<Mutant>& mutants) {
  std::set<std::string> ids;
  for (const Mutant& mutant : mutants)
    ids.insert(mutant.id());
  return ids;
}

void keep_exercise(std::vector<Mutant>& mutants, const std::string& exercise) {
  std::erase_if(mutants, [&](const Mutant& mutant) { return mutant.exercise != exercise; });
}

/// `possible`: the ids of all mutants of these solutions, graded or not.
void compare_with_list(Adequacy& adequacy, const std::vector<Original>& originals,
                       const std::set<std::string>& possible) {
  for (const MutantResult& result : adequacy.mutants) {
    const std::string id = result.mutant.id();
    if (result.fate == Fate::kGraderFailed) {
      adequacy.grader_errors.push_back(id + ": " + result.verdict);
      continue;
    }
    const bool listed = adequacy.reviewed.count(id) != 0;
    const bool survived = result.fate == Fate::kSurvived;
    const bool explained = !reason_of(result.mutant, adequacy.reviewed).empty();
    if (survived && !explained) adequacy.unexplained.push_back(id);
    if (listed && !survived) adequacy.outdated.push_back(id);
  }
  for (const auto& entry : adequacy.reviewed) {
    const std::string& id = entry.first;
    const bool is_of_these = std::any_of(
        originals.begin(), originals.end(),
        [&](const Original& original) { return id.rfind(original.name + "/", 0) == 0; });
    if (is_of_these && possible.count(id) == 0) adequacy.outdated.push_back(id);
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

/// Those that are drawn; and where single pointers are looked at, all that set one wrong.
std::vector<Mutant> choose(const std::vector<Mutant>& mutants, const AdequacyOptions& options) {
  std::vector<Mutant> chosen = mutants;
  if (options.mutants != 0)
    chosen = draw(std::move(chosen), options.mutants, Random(options.seed, "mutants"));
  if (!options.single_pointers) return chosen;
  const std::set<std::string> drawn = ids_of(chosen);
  std::copy_if(mutants.begin(), mutants.end(), std::back_inserter(chosen),
               [&](const Mutant& mutant) {
                 return drawn.count(mutant.id()) == 0 && wrong_pointers(mutant).size() == 1;
               });
  return chosen;
}

std::vector<SinglePointers> spoil_single_pointers(const Assignment& assignment,
                                                  const std::vector<Original>& originals,
                                                  const AdequacyOptions& options,
                                                  const Pipeline& pipeline) {
  std::vector<SinglePointers> all;
  if (!options.single_pointers) return all;
  for (const ExerciseRubric& rubric : assignment.exercises) {
    if (!find_exercise_judge(rubric).counts_pointers) continue;
    if (!options.exercise.empty() && rubric.name != options.exercise) continue;
    for (const Original& original : originals) {
      all.push_back(judge_single_pointers(rubric, pipeline.run(original, rubric),
                                          assignment.tolerance, options.seed));
    }
  }
  return all;
}

}  // namespace

std::string reason_of(const Mutant& mutant, const SurvivorList& reviewed) {
  for (const std::string& id : {mutant.id(), mutant.always}) {
    const auto found = reviewed.find(id);
    if (found != reviewed.end()) return found->second;
  }
  return "";
}

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
                          const Pipeline& pipeline, const JobProgress& progress) {
  const GradeFunction& grade = pipeline.grade;
  Adequacy adequacy;
  adequacy.options = options;
  adequacy.reviewed = reviewed;
  for (const ExerciseRubric& rubric : assignment.exercises)
    adequacy.exercises.push_back(rubric.name);
  std::vector<Mutant> mutants = find_mutants(originals);
  const std::set<std::string> possible = ids_of(mutants);
  if (!options.exercise.empty()) keep_exercise(mutants, options.exercise);
  adequacy.possible_mutants = mutants.size();
  std::vector<Mutant> chosen = choose(mutants, options);
  if (options.survivors_only) {
    const std::size_t all = chosen.size();
    chosen =
        without_failing(assignment, originals, chosen, pipeline.fails, options.jobs, progress);
    adequacy.failed_at_once = all - chosen.size();
  }
  adequacy.mutants =
      grade_mutants(assignment, originals, chosen, grade, options.jobs, progress);
  compare_with_list(adequacy, originals, possible);
  adequacy.single_pointers = spoil_single_pointers(assignment, originals, options, pipeline);
  // make_variant() knows how these two are laid out.
  const std::vector<Original> laid_out(
      originals.begin(), originals.begin() + static_cast<std::ptrdiff_t>(
                                                 std::min<std::size_t>(2, originals.size())));
  adequacy.variants =
      grade_variants(laid_out, options.variants, options.seed, grade, options.jobs, progress);
  adequacy.determinism = compare_runs(assignment, originals,
                                      draw(without_time_limit(adequacy.mutants),
                                           options.repeated, Random(options.seed, "repeated")),
                                      grade, progress);
  return adequacy;
}

}  // namespace meshgrade
