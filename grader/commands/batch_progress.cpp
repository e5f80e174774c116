#include "grader/commands/batch_progress.h"

#include <cmath>
#include <iostream>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

/// In the order in which they are shown.
const std::vector<std::string>& kinds() {
  static const std::vector<std::string> all{"full", "partial", "zero", "ungradable",
                                            "grader error"};
  return all;
}

std::string kind_of(const BatchStep& step) {
  if (step.status != ResultStatus::kGraded) return status_name(step.status);
  if (step.points >= step.max_points) return "full";
  return step.points > 0.0 ? "partial" : "zero";
}

std::string duration_text(double seconds) {
  if (seconds < 60.0) return number_text(std::ceil(seconds)) + " s";
  if (seconds < 5400.0) return number_text(std::ceil(seconds / 60.0)) + " min";
  return number_text(std::ceil(seconds / 360.0) / 10.0) + " h";
}

}  // namespace

void BatchProgress::count(const BatchStep& step) {
  ++done_;
  kept_ += step.kept ? 1 : 0;
  again_ += step.again ? 1 : 0;
  ++kinds_[kind_of(step)];
}

std::string BatchProgress::bar(double seconds) const {
  constexpr std::size_t kWidth = 20;
  const std::size_t filled = count_ == 0 ? kWidth : kWidth * done_ / count_;
  std::string text = "[" + std::string(filled, '#') + std::string(kWidth - filled, '.') + "] " +
                     std::to_string(done_) + "/" + std::to_string(count_);
  std::vector<std::string> counts;
  for (const std::string& kind : kinds()) {
    const auto found = kinds_.find(kind);
    if (found != kinds_.end()) counts.push_back(std::to_string(found->second) + " " + kind);
  }
  if (!counts.empty()) text += "  " + join(counts, ", ");
  // What was kept took no time and says nothing about the others.
  const std::size_t graded = done_ - kept_;
  if (graded > 0 && done_ < count_) {
    text += "; " +
            duration_text(seconds / static_cast<double>(graded) *
                          static_cast<double>(count_ - done_)) +
            " left";
  }
  return text;
}

std::string BatchProgress::line(const BatchStep& step) const {
  std::string text = std::to_string(done_) + "/" + std::to_string(count_) + " " +
                     roster_.hand_ins[step.hand_in].key + ": ";
  if (step.status == ResultStatus::kGraded) {
    text += number_text(step.points) + " of " + number_text(step.max_points) + " points";
  } else {
    text += status_name(step.status);
  }
  if (step.kept) text += " (unchanged)";
  if (step.again) {
    text += " (at the second try, after an error of the grader: " + step.reason + ")";
  } else if (!step.reason.empty()) {
    text += " (" + step.reason + ")";
  }
  return text;
}

void BatchProgress::show(const BatchStep& step) {
  count(step);
  if (!terminal_) {
    std::cerr << line(step) << "\n" << std::flush;
    return;
  }
  const bool is_news = step.again || step.status == ResultStatus::kUngradable ||
                       step.status == ResultStatus::kGraderError;
  std::cerr << "\r\033[K";
  if (is_news) std::cerr << line(step) << "\n";
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  std::cerr << bar(passed.count()) << std::flush;
}

void BatchProgress::finish() const {
  if (terminal_) std::cerr << "\r\033[K" << std::flush;
}

}  // namespace meshgrade
