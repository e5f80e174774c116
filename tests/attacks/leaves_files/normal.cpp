// Leaves files in every place that is open to all.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  for (const char* name :
       {"/tmp/" LEFT_BEHIND, "/var/tmp/" LEFT_BEHIND, "/dev/shm/" LEFT_BEHIND,
        "/run/" LEFT_BEHIND, "/" LEFT_BEHIND, LEFT_BEHIND}) {
    expect_refusal(name, ::open(name, O_CREAT | O_WRONLY, 0666) >= 0);
    expect_refusal(name, ::mkdir(name, 0777) == 0);
    expect_refusal(name, ::symlink(SECRET_FILE, name) == 0);
    expect_refusal(name, ::mkfifo(name, 0666) == 0);
  }
}
