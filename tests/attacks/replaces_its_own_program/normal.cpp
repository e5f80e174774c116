// Writes into the program that is run again for the next case.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  expect_refusal("own program", ::open("worker", O_WRONLY) >= 0);
  expect_refusal("own name", ::rename("worker", "other") == 0);
  expect_refusal("own mode", ::chmod("worker", 0777) == 0);
  expect_refusal("own folder", ::chmod(".", 0777) == 0);
}
