#include "grader/base/stage_times.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace meshgrade {

void StageTimes::add(const std::string& name, double milliseconds) {
  const std::lock_guard lock(mutex_);
  auto stage = std::find_if(stages_.begin(), stages_.end(),
                            [&](const Stage& s) { return s.name == name; });
  if (stage == stages_.end()) stage = stages_.insert(stages_.end(), {name, 0, 0.0});
  ++stage->count;
  stage->milliseconds += milliseconds;
}

std::vector<Stage> StageTimes::stages() const {
  const std::lock_guard lock(mutex_);
  return stages_;
}

StageTimer::~StageTimer() {
  if (times_ == nullptr) return;
  const std::chrono::duration<double, std::milli> passed =
      std::chrono::steady_clock::now() - begin_;
  times_->add(name_, passed.count());
}

std::string to_table(const std::vector<Stage>& stages, double all_milliseconds) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(0);
  const auto line = [&](const std::string& name, const std::string& count, double ms) {
    text << "  " << std::left << std::setw(34) << name << std::right << std::setw(6) << count
         << std::setw(9) << ms << " ms\n";
  };
  for (const Stage& stage : stages)
    line(stage.name, std::to_string(stage.count), stage.milliseconds);
  line("from start to end", "", all_milliseconds);
  return text.str();
}

}  // namespace meshgrade
