#pragma once

#include <map>
#include <string>
#include <vector>

#include "grader/batch/class_results.h"

namespace meshgrade {

/// How one exercise went.
struct ExerciseSummary {
  std::string name;
  double max_points = 0.0;
  double mean_points = 0.0;                     ///< of those who were graded
  std::size_t full = 0;                         ///< how many have all required points
  std::map<std::string, std::size_t> verdicts;  ///< how many have which
};

/// Something that went wrong with several, and with whom.
struct CommonFault {
  std::string name;      ///< of the rule or the misconception
  std::string exercise;  ///< where
  std::string meaning;   ///< of the rule; or the advice that is given
  std::vector<std::string> keys;
};

/// A hand-in to look at, and why.
struct Remark {
  std::string key;
  std::string why;
};

/// A class at a glance.
struct ClassSummary {
  std::string assignment;
  std::map<std::string, std::size_t> statuses;  ///< how many hand-ins have which
  double max_points = 0.0;
  double mean = 0.0;  ///< of those who were graded, without extra credit; so all below
  double median = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
  std::vector<std::size_t> distribution;  ///< of 0 to 10 %, ..., 90 to below 100 %, 100 %
  std::size_t late = 0;
  std::vector<Remark> late_ones;  ///< who they are, and what was taken off
  std::size_t without_time = 0;   ///< of whom a rule for late work cannot tell
  std::vector<ExerciseSummary> exercises;
  std::vector<CommonFault> rules;           ///< broken rules, the most common first
  std::vector<CommonFault> misconceptions;  ///< that explain the numbers; the same
  std::vector<Remark> not_graded;
  std::vector<Remark> undecided;   ///< exercises about which nothing could be said
  std::vector<Remark> suspicious;  ///< what only somebody does who wants to deceive the grader
  std::vector<Omission> left_out;
};

/// Looks into each report once.
ClassSummary summarize(const ClassResults& results, const ResultStore& store);

/// As JSON; docs/batch.md explains the keys.
std::string to_json(const ClassSummary& summary);

/// For people to read.
std::string to_text(const ClassSummary& summary);

}  // namespace meshgrade
