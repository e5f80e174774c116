#include "grader/batch/class_diff.h"

#include <cmath>
#include <map>
#include <set>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

const ClassRow* find_row(const ClassResults& results, const std::string& key) {
  for (const ClassRow& row : results.rows) {
    if (row.key == key) return &row;
  }
  return nullptr;
}

double points_of(const ClassRow* row) {
  return row == nullptr ? 0.0 : row->points + row->extra_points;
}

std::string state_of(const ClassRow* row) {
  if (row == nullptr) return "not there";
  if (row->status != ResultStatus::kGraded) return status_name(row->status);
  return number_text(points_of(row), 10) + " points";
}

/// Exercises whose points are not the same.
std::set<std::string> changed_exercises(const ClassRow* before, const ClassRow* after) {
  std::map<std::string, double> points;
  for (const auto& [row, sign] : {std::pair{before, -1.0}, std::pair{after, 1.0}}) {
    if (row == nullptr) continue;
    for (const ExercisePoints& e : row->exercises)
      points[e.name] += sign * (e.points + e.extra_points);
  }
  std::set<std::string> changed;
  for (const auto& [name, difference] : points) {
    if (std::abs(difference) > 1e-9) changed.insert(name);
  }
  return changed;
}

std::map<std::string, std::string> verdicts(const Result& result,
                                            const std::set<std::string>& exercises) {
  std::map<std::string, std::string> all;
  if (!result.report) return all;
  for (const ExerciseReport& exercise : result.report->exercises) {
    if (exercises.count(exercise.name) == 0) continue;
    for (const CaseReport& c : exercise.cases)
      all[c.id] = verdict_name(c.verdict);
  }
  return all;
}

std::vector<CaseChange> compare_cases(const Result& before, const Result& after,
                                      const std::set<std::string>& exercises) {
  std::map<std::string, CaseChange> all;
  for (const auto& [id, verdict] : verdicts(before, exercises))
    all[id] = {id, verdict, ""};
  for (const auto& [id, verdict] : verdicts(after, exercises)) {
    all[id].id = id;
    all[id].after = verdict;
  }
  std::vector<CaseChange> changes;
  for (const auto& [id, change] : all) {
    if (change.before != change.after) changes.push_back(change);
  }
  return changes;
}

std::string or_absent(const std::string& verdict) {
  return verdict.empty() ? "no such case" : verdict;
}

}  // namespace

std::vector<RowChange> compare_classes(const ClassResults& old_results,
                                       const ResultStore& old_store,
                                       const ClassResults& new_results,
                                       const ResultStore& new_store) {
  std::set<std::string> keys;
  for (const ClassResults* results : {&old_results, &new_results}) {
    for (const ClassRow& row : results->rows)
      keys.insert(row.key);
  }
  std::vector<RowChange> changes;
  for (const std::string& key : keys) {
    const ClassRow* before = find_row(old_results, key);
    const ClassRow* after = find_row(new_results, key);
    const std::set<std::string> exercises = changed_exercises(before, after);
    if (state_of(before) == state_of(after) && exercises.empty()) continue;
    changes.push_back({key, state_of(before), state_of(after),
                       points_of(after) - points_of(before),
                       compare_cases(old_store.load(key), new_store.load(key), exercises)});
  }
  return changes;
}

std::string to_text(const std::vector<RowChange>& changes, std::size_t most_cases) {
  std::string text;
  for (const RowChange& change : changes) {
    text += printable(change.key) + ": " + change.before + " -> " + change.after + " (" +
            (change.difference > 0.0 ? "+" : "") + number_text(change.difference, 10) + ")\n";
    for (std::size_t i = 0; i < change.cases.size(); ++i) {
      if (i == most_cases) {
        text += "  and " + plural(change.cases.size() - i, "more case") + "\n";
        break;
      }
      const CaseChange& c = change.cases[i];
      text += "  " + printable(c.id) + ": " + or_absent(c.before) + " -> " +
              or_absent(c.after) + "\n";
    }
  }
  return text;
}

}  // namespace meshgrade
