// Reads the accounts of the machine.
#include <dirent.h>

#include "attack.h"

void attack() {
  expect_refusal("shadow", std::fopen("/etc/shadow", "r") != nullptr);
  expect_refusal("passwd", std::fopen("/etc/passwd", "r") != nullptr);
  expect_refusal("root", ::opendir("/root") != nullptr);
  expect_refusal("home", ::opendir("/home") != nullptr);
}
