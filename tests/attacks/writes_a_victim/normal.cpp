// Writes, moves, links and removes a file of the instructor.
#include <fcntl.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  expect_refusal("open", ::open(VICTIM_FILE, O_WRONLY | O_TRUNC) >= 0);
  expect_refusal("truncate", ::truncate(VICTIM_FILE, 0) == 0);
  expect_refusal("rename", ::rename(VICTIM_FILE, "/tmp/" LEFT_BEHIND) == 0);
  expect_refusal("link", ::link(VICTIM_FILE, "/tmp/" LEFT_BEHIND "2") == 0);
  expect_refusal("unlink", ::unlink(VICTIM_FILE) == 0);
}
