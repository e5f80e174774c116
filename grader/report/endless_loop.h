#pragma once

#include <optional>
#include <string>

namespace meshgrade {

/// A loop of a source that a line lies in.
struct EnclosingLoop {
  int line = 0;  ///< from 1: where its condition stands
  /// It counts up to an end, "for (...; i < n; ++i)": such a loop is endless only if nothing
  /// else can be.
  bool counts = false;
};

/// The innermost loop around a line (from 1) that does not count; where all of them do, the
/// innermost one; nothing if there is none. Reads braces and keywords only: a loop that a macro
/// makes is not seen.
std::optional<EnclosingLoop> enclosing_loop(const std::string& source, int line);

}  // namespace meshgrade
