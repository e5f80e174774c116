// Throws a text of commands for terminals, and a long one.
#include <stdexcept>
#include <string>

#include "attack.h"

void attack() {
  std::string text = "first\nsecond \033[2J\x9b<script>\xe2\x80\xae";
  throw std::runtime_error(text + std::string(1 << 20, 'x'));
}
