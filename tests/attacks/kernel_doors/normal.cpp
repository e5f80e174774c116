// Tries the calls of the kernel that are hardest to get right.
#include <sys/syscall.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  char room[256] = {};
  expect_refusal("io_uring_setup", ::syscall(425, 8, room) >= 0);
  expect_refusal("bpf", ::syscall(SYS_bpf, 0, room, sizeof room) >= 0);
  expect_refusal("perf_event_open", ::syscall(SYS_perf_event_open, room, 0, -1, -1, 0) >= 0);
  expect_refusal("userfaultfd", ::syscall(SYS_userfaultfd, 1) >= 0);
  expect_refusal("keyctl", ::syscall(SYS_keyctl, 0, -3, 1) >= 0);
  expect_refusal("add_key", ::syscall(SYS_add_key, "user", "x", "y", 1, -3) >= 0);
  expect_refusal("kcmp", ::syscall(SYS_kcmp, ::getpid(), ::getppid(), 0, 0, 0) >= 0);
  expect_refusal("pidfd_getfd", ::syscall(438, ::syscall(434, ::getppid(), 0), 0, 0) >= 0);
  expect_refusal("io_setup", ::syscall(SYS_io_setup, 1, room) >= 0);
  expect_refusal("fanotify", ::syscall(SYS_fanotify_init, 0, 0) >= 0);
  expect_refusal("handle",
                 ::syscall(SYS_name_to_handle_at, -100, "/", room, room + 128, 0) >= 0);
}
