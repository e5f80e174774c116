// Mounts, and changes its root.
#include <sys/mount.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  expect_refusal("mount", ::mount("none", "/tmp", "tmpfs", 0, nullptr) == 0);
  expect_refusal("remount",
                 ::mount("none", "/usr", nullptr, MS_REMOUNT | MS_BIND, nullptr) == 0);
  expect_refusal("umount", ::umount("/usr") == 0);
  expect_refusal("chroot", ::chroot("/") == 0);
  expect_refusal("pivot_root", ::syscall(SYS_pivot_root, "/", "/") == 0);
  expect_refusal("fsopen", ::syscall(430, "tmpfs", 0) >= 0);
  expect_refusal("open_tree", ::syscall(428, -100, "/", 1) >= 0);
}
