#pragma once

#include <string>

#include "grader/grade/grading.h"

namespace meshgrade {

/// Whether to color what goes to stdout: `choice` is "auto", "always" or "never".
bool use_color(const std::string& choice);

/// Shows on a terminal what is going on, in one line that is written over, and nothing
/// elsewhere. An empty text clears the line.
Progress terminal_progress();

/// The text as one word of a shell command.
std::string shell_word(const std::string& text);

/// The program as it was called, to be printed in commands: "./meshgrade".
std::string called_as();

}  // namespace meshgrade
