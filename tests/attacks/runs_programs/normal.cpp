// Starts programs of the system.
#include <sys/wait.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  expect_refusal("system", std::system("true") == 0);
  for (const char* program : {"/bin/sh", "/bin/bash", "/usr/bin/env", "/usr/bin/python3",
                              "/usr/bin/perl", "/bin/ls"}) {
    if (::fork() == 0) {
      ::execl(program, program, "-c", "echo BREACH", nullptr);
      std::_Exit(0);
    }
    ::wait(nullptr);
  }
}
