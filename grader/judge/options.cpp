#include "grader/judge/options.h"

#include "grader/base/contains.h"
#include "grader/base/errors.h"
#include "grader/base/text.h"

namespace meshgrade {

void refuse_unknown_options(const ExerciseRubric& rubric,
                            const std::vector<std::string>& known) {
  for (const auto& [name, option] : rubric.options) {
    if (contains(known, name)) continue;
    throw UserError(option.place + ": " + rubric.name + " has no option \"" + name + "\"" +
                    (known.empty() ? "" : "; it knows " + join(known, ", ")));
  }
}

std::string choose_option(const ExerciseRubric& rubric, const std::string& option,
                          const std::vector<std::string>& choices) {
  const auto found = rubric.options.find(option);
  if (found == rubric.options.end()) return choices.at(0);
  const auto& [value, place] = found->second;
  if (contains(choices, value)) return value;
  throw UserError(place + ": the option " + option + " of " + rubric.name + " must be one of " +
                  join(choices, ", ") + ", not \"" + value + "\"");
}

}  // namespace meshgrade
