#pragma once

#include <unistd.h>

#include <iostream>
#include <string>

namespace meshgrade {

/// A bar on stderr that is drawn over itself and gone in the end.
class ProgressBar {
 public:
  ProgressBar() = default;
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar() {
    if (drawn_ >= 0) std::cerr << "\r" << std::string(kWidth + 8, ' ') << "\r" << std::flush;
  }

  /// Whether there is somebody who would see it.
  static bool is_wanted() { return isatty(STDERR_FILENO) != 0; }

  /// @param done  the part of the work that is done, from 0 to 1
  void show(double done) {
    const int percent = static_cast<int>(100 * done);
    if (percent == drawn_) return;
    drawn_ = percent;
    const auto filled = static_cast<std::size_t>(percent) * kWidth / 100;
    std::cerr << "\r[" << std::string(filled, '#') << std::string(kWidth - filled, ' ') << "] "
              << percent << "%" << std::flush;
  }

 private:
  static constexpr std::size_t kWidth = 50;
  int drawn_ = -1;
};

}  // namespace meshgrade
