#include "grader/grade/left_over_calls.h"

#include <algorithm>

#include "grader/base/pattern.h"
#include "grader/base/text.h"
#include "grader/submission/code_only.h"
#include "grader/submission/function_extents.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostShown = 40;  ///< characters of what is printed

int line_number_at(const std::string& text, std::size_t offset) {
  return 1 + static_cast<int>(std::count(
                 text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

void note_calls_in(const SourceFile& file, const std::vector<std::string>& functions,
                   JudgedExercise& exercise) {
  static const Pattern call("\\b(?:validate|describe)\\s?\\(");
  for (const FunctionExtent& function : find_functions(file.text)) {
    if (std::find(functions.begin(), functions.end(), function.name) == functions.end())
      continue;
    const std::string body =
        code_only(file.text).substr(function.body, function.end - function.body);
    for (const auto& [at, size] : call.places_in(body)) {
      const std::string name = body.substr(at, body.find_first_of(" (", at) - at);
      exercise.notes.push_back(file.name + ", line " +
                               std::to_string(line_number_at(file.text, function.body + at)) +
                               ": " + name +
                               "() looks at the whole mesh; take it out before you hand in");
    }
  }
}

}  // namespace

void note_left_over_calls(const Submission& submission,
                          const std::vector<std::string>& functions, JudgedExercise& exercise) {
  if (!is_scotty3d(submission.dialect)) return;
  for (const SourceFile& file : submission.sources)
    note_calls_in(file, functions, exercise);
  for (const JudgedCase& c : exercise.cases) {
    if (c.judgement.verdict != Verdict::kPassed || c.output_bytes == 0) continue;
    const std::string line = printable(c.output.substr(0, c.output.find('\n')));
    exercise.notes.push_back("it prints while it works, for example \"" +
                             line.substr(0, kMostShown) +
                             "\"; take that out before you hand in");
    return;
  }
}

}  // namespace meshgrade
