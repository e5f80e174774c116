#include "grader/mutants/adequacy_page.h"

#include <algorithm>
#include <functional>
#include <map>

#include "grader/base/text.h"
#include "grader/mutants/operators.h"

namespace meshgrade {
namespace {

constexpr const char* kHead =
    "# How well the grader grades\n"
    "\n"
    "This page is written by `meshgrade dev-check --mutants`; do not edit it. The command "
    "makes\n"
    "right solutions wrong by one small change each (a *mutant*), grades all of them by the\n"
    "ordinary pipeline, and looks at what the reports say. It also grades other right "
    "solutions,\n"
    "which must lose nothing.\n"
    "\n"
    "Six right solutions are changed: the model solution in `reference/`, and five in\n"
    "`tests/mutants/`, in styles that students write more often than its terse one:\n"
    "\n"
    "- `textbook`: every handle of the neighbourhood has a name, and `setNeighbors` sets all\n"
    "  pointers. It offers the most pointers to get wrong.\n"
    "- `singles`: by the course's numbered diagram, each pointer by an assignment of its own.\n"
    "- `turned`: the half-edges inside turn: they keep their `next`, and get new vertices, "
    "edges\n"
    "  and twins.\n"
    "- `arrays`: handles in lists and tables; the subdivision keeps everything in lists.\n"
    "- `floats`: triangles and edges are put together by helpers; computes in float, with "
    "Loop's\n"
    "  own weights.\n"
    "\n"
    "Mistakes that are made only sometimes are among them: at the third call, above a valence "
    "of\n"
    "12, above 400 faces, on tiny edges, far from the origin, by the anchor, by the number of\n"
    "points, at one parameter.\n";

constexpr const char* kLocalisation =
    "\n"
    "- **The pointer.** Counted are the mutants of the textbook's flip and split whose "
    "changed\n"
    "  line only sets pointers, so that the line itself says which pointers are wrong. The\n"
    "  textbook's variables are named by what they are after the operation (`bm`, `edge_bm`,\n"
    "  `face_abm`), and so are the elements in findings (\"h12.next, of bm\"): the first "
    "finding\n"
    "  of the first failing case must name one of the pointers that the line sets otherwise\n"
    "  than the right one. A line that sets one element in place of another gets two wrong.\n"
    "- **The function.** Counted are all killed mutants. The first exercise that loses points\n"
    "  must be the one of the function with the mistake, not one that calls it, or a note of\n"
    "  the caller's exercise must say that with a right one in its place a case passes;\n"
    "  where an exercise has several functions, the first finding must name it.\n";

struct Tally {
  std::size_t killed = 0;
  std::size_t survived = 0;
  std::size_t not_compiled = 0;
  std::size_t failed = 0;

  void add(Fate fate) {
    killed += fate == Fate::kKilled ? 1 : 0;
    survived += fate == Fate::kSurvived ? 1 : 0;
    not_compiled += fate == Fate::kNotCompiled ? 1 : 0;
    failed += fate == Fate::kGraderFailed ? 1 : 0;
  }
  std::size_t all() const { return killed + survived + not_compiled + failed; }
};

std::string percent_text(const Share& share) {
  return std::to_string(share.part) + " of " + std::to_string(share.whole) + ", " +
         number_text(share.percent(), 3) + " %";
}

std::string row(const std::vector<std::string>& cells) {
  return "| " + join(cells, " | ") + " |\n";
}

std::string cell(const Tally& tally) {
  if (tally.killed + tally.survived == 0) return "";
  return std::to_string(tally.killed) + " / " + std::to_string(tally.killed + tally.survived);
}

using Choice = std::function<bool(const MutantResult&)>;

Tally tally_of(const Adequacy& adequacy, const Choice& choice) {
  Tally tally;
  for (const MutantResult& result : adequacy.mutants) {
    if (choice(result)) tally.add(result.fate);
  }
  return tally;
}

/// Differ from a right solution and are not noticed: none, when all is well.
std::size_t missed(const Adequacy& adequacy, const Choice& choice) {
  return static_cast<std::size_t>(std::count_if(
      adequacy.mutants.begin(), adequacy.mutants.end(), [&](const MutantResult& result) {
        return choice(result) && result.fate == Fate::kSurvived &&
               reason_of(result.mutant, adequacy.reviewed).empty();
      }));
}

std::string sample_text(const Adequacy& adequacy) {
  const std::string& only = adequacy.options.exercise;
  const std::string of = only.empty() ? "" : " of " + only;
  if (adequacy.mutants.size() == adequacy.possible_mutants) {
    return "All mutants" + of + " were graded.\n\n";
  }
  const std::size_t drawn = adequacy.options.mutants;
  const std::size_t more = adequacy.mutants.size() - drawn;
  const std::string others =
      more == 0 ? " and graded.\n\n"
                : ",\nand " + std::to_string(more) +
                      " more are the rest of those that set one pointer of the textbook's flip "
                      "or split\nwrong. All of them were graded.\n\n";
  return std::to_string(drawn) + " of the " + std::to_string(adequacy.possible_mutants) +
         " mutants" + of + " were drawn with the seed " +
         std::to_string(adequacy.options.seed) + others;
}

std::string exercise_table(const Adequacy& adequacy) {
  std::string table =
      "\n## Killed, survived, not compiled\n\n" + sample_text(adequacy) +
      "| exercise | mutants | do not compile | killed | survived, but right | missed |\n"
      "|---|---:|---:|---:|---:|---:|\n";
  const auto add = [&](const std::string& name, const Choice& choice) {
    const Tally tally = tally_of(adequacy, choice);
    const std::size_t not_seen = missed(adequacy, choice);
    table += row({name, std::to_string(tally.all()), std::to_string(tally.not_compiled),
                  std::to_string(tally.killed), std::to_string(tally.survived - not_seen),
                  std::to_string(not_seen)});
  };
  for (const std::string& exercise : adequacy.exercises) {
    add(exercise, [&](const MutantResult& r) { return r.mutant.exercise == exercise; });
  }
  add("**all**", [](const MutantResult&) { return true; });
  return table;
}

std::string operator_table(const Adequacy& adequacy) {
  std::vector<std::string> head{"operator", "what it does"};
  head.insert(head.end(), adequacy.exercises.begin(), adequacy.exercises.end());
  std::string table =
      "\nKilled of those that compile, by operator:\n\n" + row(head) + "|---|---|";
  for (std::size_t i = 0; i < adequacy.exercises.size(); ++i)
    table += "---:|";
  table += "\n";
  for (const MutationOperator& mutation : mutation_operators()) {
    std::vector<std::string> cells{mutation.name, mutation.description};
    for (const std::string& exercise : adequacy.exercises) {
      cells.push_back(cell(tally_of(adequacy, [&](const MutantResult& r) {
        return r.mutant.exercise == exercise && r.mutant.operator_name == mutation.name;
      })));
    }
    table += row(cells);
  }
  return table;
}

std::string survivors(const Adequacy& adequacy) {
  std::map<std::string, std::vector<std::string>> by_reason;
  for (const MutantResult& result : adequacy.mutants) {
    if (result.fate != Fate::kSurvived) continue;
    const std::string reason = reason_of(result.mutant, adequacy.reviewed);
    by_reason[reason.empty() ? "**Not explained: the grader misses these.**" : reason]
        .push_back(result.mutant.id());
  }
  std::string text =
      "\n## Survivors\n\nNo mutant but these gets full points. Each was looked at: no caller "
      "that keeps to the contract\ncan tell it from a right solution. The list is "
      "`tests/mutants/survivors.toml`.\n";
  for (const auto& [reason, ids] : by_reason) {
    text += "\n" + reason + "\n\n";
    for (const std::string& id : ids)
      text += "- `" + id + "`\n";
  }
  return text;
}

std::string misses(const Adequacy& adequacy) {
  std::string text;
  for (const MutantResult& result : adequacy.mutants) {
    if (result.fate != Fate::kKilled) continue;
    const std::string mutant = "- `" + result.mutant.id() + "`: ";
    if (!result.names_function) {
      text += mutant + "named as " + result.first_exercise + ", " + result.verdict + "\n";
    } else if (!result.wrong_pointers.empty() && !result.names_pointer()) {
      const std::string named =
          result.element.empty() ? "no pointer" : "`" + result.element + "`";
      text.append(mutant).append("the first finding names ").append(named).append("\n");
    }
  }
  return text.empty() ? text : "\nWhere it does not:\n\n" + text;
}

std::string single_pointers(const Adequacy& adequacy) {
  std::string table =
      "\n### One wrong pointer\n\nEach solution's flip and split is run, and in the mesh that "
      "it "
      "leaves behind one pointer is changed,\nof an element that is new or has changed: to any "
      "other element of its kind, or to none. The list of\nwrong pointers must hold this one "
      "alone (99 %), and name it first (95 %; where another single pointer\nwould mend the "
      "mesh as "
      "well, that one may be named), within 10 ms.\n\n"
      "| solution | exercise | changed | listed alone | named first | 99 % within |\n"
      "|---|---|---:|---:|---:|---:|\n";
  for (const SinglePointers& sums : adequacy.single_pointers) {
    const auto share = [&](std::size_t part) {
      return number_text(Share{part, sums.tried}.percent(), 4) + " %";
    };
    table += row({sums.solution, sums.exercise, std::to_string(sums.tried), share(sums.alone),
                  share(sums.first), number_text(sums.milliseconds, 2) + " ms"});
  }
  return table;
}

std::string localisation(const Adequacy& adequacy) {
  return "\n## Where the findings point\n\n| the first finding names | mutants | target |\n"
         "|---|---:|---:|\n" +
         row({"the pointer that is wrong", percent_text(pointers_named(adequacy)), "95 %"}) +
         row({"the function that is wrong", percent_text(functions_named(adequacy)), "99 %"}) +
         kLocalisation + misses(adequacy) + single_pointers(adequacy);
}

/// "0 / 10 / 45 %": the least, the median and the most of these shares.
std::string spread_text(std::vector<double> shares) {
  std::sort(shares.begin(), shares.end());
  const auto percent = [&](std::size_t i) { return number_text(100.0 * shares[i], 3); };
  return percent(0) + " / " + percent(shares.size() / 2) + " / " + percent(shares.size() - 1) +
         " %";
}

std::string points_table(const Adequacy& adequacy) {
  std::string table =
      "\n## What one wrong pointer costs\n\nOf all mutants of the textbook's flip and split "
      "that "
      "set exactly one pointer wrong and are\nfound: the share of the exercise's points that "
      "is "
      "left, as the least, the median and the most.\n\n"
      "| exercise | mutants | if groups gave all or nothing | as they give parts by pointers "
      "|\n"
      "|---|---:|---:|---:|\n";
  for (const std::string& exercise : adequacy.exercises) {
    std::vector<double> whole;
    std::vector<double> parts;
    for (const MutantResult& result : adequacy.mutants) {
      if (result.mutant.exercise != exercise || result.fate != Fate::kKilled ||
          result.wrong_pointers.size() != 1) {
        continue;
      }
      whole.push_back(result.points_without_parts);
      parts.push_back(result.points);
    }
    if (whole.empty()) continue;
    table +=
        row({exercise, std::to_string(whole.size()), spread_text(whole), spread_text(parts)});
  }
  return table;
}

std::string list_text(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items)
    text += "- " + item + "\n";
  return text;
}

std::string right_answers(const Adequacy& adequacy) {
  const VariantsResult& variants = adequacy.variants;
  const DeterminismResult& same = adequacy.determinism;
  return "\n## Right answers\n\n" + std::to_string(variants.drawn) + " variants, " +
         std::to_string(variants.different) +
         " of them different from all others, were drawn with the seed " +
         std::to_string(adequacy.options.seed) +
         "\nand graded six to a submission: other orders of creation, other parts for old "
         "elements, other\nanchors, other orders of assignments and sums, float for double, "
         "other names. " +
         (variants.refused.empty() ? "All have full points.\n"
                                   : "These lose points:\n\n" + list_text(variants.refused)) +
         "\n## The same again\n\n" + plural(same.submissions, "wrong submission") +
         " were graded three times: one at a time, and twice with two at a\ntime. " +
         (same.differing.empty() ? "The JSON reports are the same, byte for byte.\n"
                                 : "These differ:\n\n" + list_text(same.differing));
}

}  // namespace

std::string to_markdown(const Adequacy& adequacy) {
  return kHead + exercise_table(adequacy) + operator_table(adequacy) + localisation(adequacy) +
         points_table(adequacy) + right_answers(adequacy) + survivors(adequacy);
}

std::string to_summary(const Adequacy& adequacy) {
  const Tally tally = tally_of(adequacy, [](const MutantResult&) { return true; });
  const auto complain = [](const std::string& what, const std::vector<std::string>& items) {
    return items.empty() ? "" : what + ":\n" + list_text(items);
  };
  const std::size_t at_once = adequacy.failed_at_once;
  return plural(tally.all() + at_once, "mutant") + ": " +
         std::to_string(tally.killed + at_once) + " killed, " + std::to_string(tally.survived) +
         " survived (" + std::to_string(adequacy.unexplained.size()) + " not explained), " +
         std::to_string(tally.not_compiled) + " do not compile\n" +
         "the first finding names the pointer: " + percent_text(pointers_named(adequacy)) +
         "\nthe report names the function: " + percent_text(functions_named(adequacy)) + "\n" +
         plural(adequacy.variants.drawn, "right variant") + ": " +
         std::to_string(adequacy.variants.refused.size()) + " refused\n" +
         plural(adequacy.determinism.submissions, "submission") +
         " graded three times: " + std::to_string(adequacy.determinism.differing.size()) +
         " with different reports\n" +
         complain("survivors that are not explained", adequacy.unexplained) +
         complain("the grader itself fails on", adequacy.grader_errors) +
         complain("listed as survivors, but killed or gone", adequacy.outdated) +
         complain("right answers that lose points", adequacy.variants.refused) +
         complain("different reports for the same submission", adequacy.determinism.differing);
}

}  // namespace meshgrade
