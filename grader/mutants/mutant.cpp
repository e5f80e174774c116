#include "grader/mutants/mutant.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "grader/mutants/operators.h"

namespace meshgrade {
namespace {

/// Every run of white space as one space, none at the ends.
std::string as_one_line(std::string_view text) {
  std::string line;
  for (char c : text) {
    const bool space = c == ' ' || c == '\n' || c == '\t';
    if (space && (line.empty() || line.back() == ' ')) continue;
    line += space ? ' ' : c;
  }
  while (!line.empty() && line.back() == ' ')
    line.pop_back();
  return line;
}

/// The whole lines from character `begin` to `end`.
std::string_view lines_around(std::string_view text, std::size_t begin, std::size_t end) {
  const std::size_t before = begin == 0 ? std::string_view::npos : text.rfind('\n', begin - 1);
  const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
  const std::size_t last = std::min(text.find('\n', end), text.size());
  return text.substr(first, last - first);
}

std::size_t token_at(const SourceCode& code, std::size_t place) {
  std::size_t i = 0;
  while (i + 1 < code.tokens().size() && code.tokens()[i].at < place)
    ++i;
  return i;
}

}  // namespace

std::string Mutant::id() const {
  const std::string number = repetition == 0 ? "" : " #" + std::to_string(repetition + 1);
  return original + "/" + file + ": " + operator_name + ": " + was + " => " + becomes + number;
}

std::vector<Mutant> make_mutants(const Original& original, const SourceFile& file) {
  const SourceCode code(file.text);
  std::set<std::string> known{file.text};
  std::map<std::pair<std::size_t, std::size_t>, std::string> dropped;  // place -> id
  std::map<std::string, std::size_t> repetitions;
  std::vector<Mutant> mutants;
  for (const MutationOperator& mutation : mutation_operators()) {
    for (const Edit& edit : mutation.edits(code)) {
      Mutant mutant;
      mutant.text = file.text;
      mutant.text.replace(edit.at, edit.size, edit.text);
      mutant.text.insert(edit.prelude_at, edit.prelude);
      if (!known.insert(mutant.text).second) continue;
      mutant.original = original.name;
      mutant.file = file.name;
      mutant.exercise = file.name.substr(0, file.name.find('.'));
      mutant.operator_name = mutation.name;
      const Function* function = code.function_at(token_at(code, edit.at));
      if (function != nullptr) mutant.function = function->name;
      mutant.line = 1 + static_cast<std::size_t>(std::count(
                            file.text.begin(),
                            file.text.begin() + static_cast<std::ptrdiff_t>(edit.at), '\n'));
      mutant.was = as_one_line(lines_around(file.text, edit.at, edit.at + edit.size));
      mutant.becomes =
          as_one_line(lines_around(mutant.text, edit.at + edit.prelude.size(),
                                   edit.at + edit.prelude.size() + edit.text.size()));
      mutant.repetition = repetitions[mutant.id()]++;
      if (edit.text == ";") dropped[{edit.at, edit.size}] = mutant.id();
      if (!edit.prelude.empty()) mutant.always = dropped[{edit.at, edit.size}];
      mutants.push_back(std::move(mutant));
    }
  }
  return mutants;
}

}  // namespace meshgrade
