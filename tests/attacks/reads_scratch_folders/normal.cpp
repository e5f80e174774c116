// Looks into the folders of other submissions.
#include <dirent.h>

#include "attack.h"

void attack() {
  for (const char* parent : {SCRATCH, "/tmp", "/var/tmp", "/dev/shm", "/run"}) {
    DIR* folder = ::opendir(parent);
    expect_refusal(parent, folder != nullptr && std::strcmp(parent, "/tmp") != 0);
    if (folder == nullptr) continue;
    while (const dirent* entry = ::readdir(folder))
      std::puts(entry->d_name);
  }
}
