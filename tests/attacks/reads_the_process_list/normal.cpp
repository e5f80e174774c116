// Reads about other processes in /proc.
#include <dirent.h>

#include "attack.h"

void attack() {
  DIR* folder = ::opendir("/proc");
  expect_refusal("/proc", folder != nullptr);
  expect_refusal("environ of init", std::fopen("/proc/1/environ", "r") != nullptr);
  expect_refusal("cmdline of init", std::fopen("/proc/1/cmdline", "r") != nullptr);
}
