#pragma once

// For tests that grade many submissions which differ in one function: what they have in common
// is compiled once for all of them. Whether that changes a report is asked in
// tests/commands/kept_work_test.cpp.

#include <cstdlib>

#include "grader/commands/context.h"
#include "grader/commands/kept_work.h"

namespace meshgrade {

inline const Home& home_that_keeps() {
  static const Home home = [] {
    Home kept = find_home();
    setenv("XDG_CACHE_HOME", MESHGRADE_KEPT_DIR, 1);
    keep_work(kept);
    return kept;
  }();
  return home;
}

}  // namespace meshgrade
