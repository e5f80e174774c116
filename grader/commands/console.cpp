#include "grader/commands/console.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iostream>

namespace meshgrade {

bool use_color(const std::string& choice) {
  if (choice != "auto") return choice == "always";
  return ::isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
}

Progress terminal_progress() {
  if (::isatty(STDERR_FILENO) == 0) return [](const std::string&) {};
  return [](const std::string& what) { std::cerr << "\r\033[K" << what << std::flush; };
}

std::string shell_word(const std::string& text) {
  const bool plain = std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string("/._-+:@%,=").find(char(c)) != std::string::npos;
  });
  if (plain && !text.empty()) return text;
  std::string word = "'";
  for (char c : text)
    word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string called_as() {
  // The script says how it was called: this program itself has another name.
  const char* script = std::getenv("MESHGRADE_CALLED_AS");
  return script != nullptr && *script != '\0' ? shell_word(script) : "./meshgrade";
}

}  // namespace meshgrade
