#include "grader/batch/class_summary.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

/// An honest solution does not break these: the worker itself writes what the first is about,
/// and nothing in a mesh starts processes or opens files.
bool is_suspicious(const std::string& rule) {
  static const std::set<std::string> rules{"malformed", "process-limit", "file-limit"};
  return rules.count(rule) != 0;
}

/// Extra credit of which nothing works was not tried: it is no mistake to leave it out.
std::set<std::string> skipped_groups(const ExerciseReport& exercise) {
  std::set<std::string> names;
  for (const GroupReport& group : exercise.groups) {
    if (group.extra_credit && group.passed == 0) names.insert(group.name);
  }
  return names;
}

/// Faults by exercise and name.
using Faults = std::map<std::pair<std::string, std::string>, CommonFault>;

void note(Faults& faults, const std::string& exercise, const std::string& name,
          const std::string& meaning, const std::string& key) {
  CommonFault& fault = faults[{exercise, name}];
  fault.name = name;
  fault.exercise = exercise;
  fault.meaning = meaning;
  if (fault.keys.empty() || fault.keys.back() != key) fault.keys.push_back(key);
}

std::vector<CommonFault> most_common_first(const Faults& faults) {
  std::vector<CommonFault> sorted;
  for (const auto& [name, fault] : faults)
    sorted.push_back(fault);
  std::stable_sort(
      sorted.begin(), sorted.end(),
      [](const CommonFault& a, const CommonFault& b) { return a.keys.size() > b.keys.size(); });
  return sorted;
}

class Summing {
 public:
  Summing(const ClassResults& results, const ResultStore& store)
      : results_(results), store_(store) {}

  ClassSummary run() {
    summary_.assignment = results_.assignment;
    summary_.max_points = results_.max_points;
    summary_.left_out = results_.left_out;
    for (const ExercisePoints& exercise : results_.exercises)
      summary_.exercises.push_back({exercise.name, exercise.max_points, 0.0, 0, {}});
    for (const ClassRow& row : results_.rows)
      add(row);
    add_statistics();
    summary_.rules = most_common_first(rules_);
    summary_.misconceptions = most_common_first(misconceptions_);
    return std::move(summary_);
  }

 private:
  void add(const ClassRow& row) {
    ++summary_.statuses[status_name(row.status)];
    summary_.late += row.late ? 1 : 0;
    if (row.late) summary_.late_ones.push_back({row.key, late_text(row)});
    if (!row.late && row.submitted_at.empty() && !row.late_note.empty())
      ++summary_.without_time;
    if (row.status != ResultStatus::kGraded) {
      summary_.not_graded.push_back(
          {row.key, std::string(status_name(row.status)) +
                        (row.reason.empty() ? "" : ": " + row.reason)});
      return;
    }
    points_.push_back(row.points);
    add_undecided(row);
    for (std::size_t i = 0; i < row.exercises.size(); ++i) {
      const ExercisePoints& exercise = row.exercises[i];
      ExerciseSummary& sum = summary_.exercises.at(i);
      sum.mean_points += exercise.points;
      sum.full += exercise.points >= exercise.max_points ? 1 : 0;
      ++sum.verdicts[exercise.verdict];
    }
    const Result result = store_.load(row.key);
    if (result.report) add_findings(row.key, *result.report);
  }

  void add_undecided(const ClassRow& row) {
    std::vector<std::string> open;
    for (const ExercisePoints& exercise : row.exercises) {
      if (exercise.verdict != verdict_name(Verdict::kNotJudged) || exercise.max_points <= 0.0)
        continue;
      open.push_back(exercise.name + ", " + number_text(exercise.max_points) + " points");
    }
    if (!open.empty()) summary_.undecided.push_back({row.key, join(open, "; ")});
  }

  void add_findings(const std::string& key, const Report& report) {
    for (const ExerciseReport& exercise : report.exercises) {
      const std::set<std::string> skipped = skipped_groups(exercise);
      for (const CaseReport& c : exercise.cases) {
        if (c.excused || skipped.count(c.group) != 0) continue;
        for (const FindingReport& finding : c.findings)
          add_finding(key, exercise.name, c, finding.finding);
      }
    }
  }

  void add_finding(const std::string& key, const std::string& exercise, const CaseReport& c,
                   const Finding& finding) {
    note(rules_, exercise, finding.rule, finding.meaning, key);
    for (const Misconception& likely : finding.likely)
      note(misconceptions_, exercise, likely.name, likely.advice, key);
    const bool known = !summary_.suspicious.empty() && summary_.suspicious.back().key == key;
    if (is_suspicious(finding.rule) && !known) {
      summary_.suspicious.push_back({key, c.id + ": " + finding.meaning});
    }
  }

  void add_statistics() {
    summary_.distribution.assign(11, 0);
    if (points_.empty()) return;
    const auto count = static_cast<double>(points_.size());
    for (ExerciseSummary& exercise : summary_.exercises)
      exercise.mean_points /= count;
    std::sort(points_.begin(), points_.end());
    summary_.lowest = points_.front();
    summary_.highest = points_.back();
    summary_.mean = std::accumulate(points_.begin(), points_.end(), 0.0) / count;
    const std::size_t half = points_.size() / 2;
    summary_.median =
        points_.size() % 2 == 1 ? points_[half] : (points_[half - 1] + points_[half]) / 2.0;
    for (const double points : points_) {
      const double share = results_.max_points > 0.0 ? points / results_.max_points : 1.0;
      ++summary_.distribution[static_cast<std::size_t>(std::clamp(share * 10.0, 0.0, 10.0))];
    }
  }

  const ClassResults& results_;
  const ResultStore& store_;
  ClassSummary summary_;
  std::vector<double> points_;
  Faults rules_;
  Faults misconceptions_;
};

std::string pad(const std::string& text, std::size_t width) {
  return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

std::string distribution_text(const ClassSummary& summary) {
  std::string text;
  constexpr std::size_t kWidth = 40;
  const std::size_t most = std::max<std::size_t>(
      1, *std::max_element(summary.distribution.begin(), summary.distribution.end()));
  for (std::size_t i = 0; i < summary.distribution.size(); ++i) {
    const std::size_t count = summary.distribution[i];
    const std::string label = i == 10 ? "100 %" : "from " + std::to_string(10 * i) + " %";
    std::string line = "  " + pad(label, 12) + pad(std::to_string(count), 5) +
                       std::string((kWidth * count + most - 1) / most, '#');
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string exercises_text(const ClassSummary& summary) {
  std::string text = "\nExercises\n";
  for (const ExerciseSummary& e : summary.exercises) {
    text += "  " + pad(e.name, 18) +
            pad(number_text(e.mean_points, 3) + " of " + number_text(e.max_points), 14) +
            std::to_string(e.full) + " full";
    for (const auto& [verdict, count] : e.verdicts) {
      if (verdict != "passed") text += ", " + std::to_string(count) + " " + verdict;
    }
    text += "\n";
  }
  return text;
}

std::string faults_text(const std::string& title, const std::vector<CommonFault>& faults) {
  constexpr std::size_t kMost = 12;
  if (faults.empty()) return {};
  std::string text = "\n" + title + "\n";
  for (std::size_t i = 0; i < std::min(kMost, faults.size()); ++i) {
    const CommonFault& fault = faults[i];
    text += "  " + pad(std::to_string(fault.keys.size()), 4) +
            pad(fault.exercise + ": " + fault.name, 36) + " " + fault.meaning + "\n";
  }
  return text;
}

std::string remarks_text(const std::string& title, const std::vector<Remark>& remarks) {
  std::string text = remarks.empty() ? "" : "\n" + title + "\n";
  for (const Remark& remark : remarks)
    text += "  " + printable(remark.key) + ": " + printable(remark.why) + "\n";
  return text;
}

}  // namespace

ClassSummary summarize(const ClassResults& results, const ResultStore& store) {
  return Summing(results, store).run();
}

std::string to_text(const ClassSummary& summary) {
  std::string text = summary.assignment + "\n";
  std::vector<std::string> counts;
  for (const auto& [status, count] : summary.statuses)
    counts.push_back(std::to_string(count) + " " + status);
  if (summary.late != 0) counts.push_back(std::to_string(summary.late) + " late");
  text += join(counts, ", ") + "\n\nPoints of " + number_text(summary.max_points) + ": mean " +
          number_text(summary.mean, 4) + ", median " + number_text(summary.median, 4) +
          ", lowest " + number_text(summary.lowest) + ", highest " +
          number_text(summary.highest) + "\n";
  text += distribution_text(summary) + exercises_text(summary);
  text += faults_text("Broken rules, by the number of hand-ins", summary.rules);
  text += faults_text("Misconceptions, by the number of hand-ins", summary.misconceptions);
  text += remarks_text("Late", summary.late_ones);
  if (summary.without_time != 0) {
    text += "\n" + plural(summary.without_time, "hand-in") +
            " without a time: nothing is taken off, late or not\n";
  }
  text += remarks_text("Not graded", summary.not_graded);
  text += remarks_text("Not judged: a person has to decide", summary.undecided);
  text += remarks_text("Suspected of tampering: look at these", summary.suspicious);
  std::vector<Remark> left_out;
  for (const Omission& omission : summary.left_out)
    left_out.push_back({omission.what, omission.why});
  return text + remarks_text("Left out", left_out);
}

}  // namespace meshgrade
