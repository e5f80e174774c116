// Fills memory that belongs to a nameless file.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  const long file = ::syscall(SYS_memfd_create, "hidden", 0);
  expect_refusal("memfd_create", file >= 0);
  const int shared = ::shm_open("/" LEFT_BEHIND, O_CREAT | O_RDWR, 0600);
  expect_refusal("shm_open", shared >= 0);
}
