// Makes files without end.
#include <fcntl.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  int made = 0;
  for (int i = 0; i < 20000; ++i) {
    char name[64];
    std::snprintf(name, sizeof name, "%d.txt", i);
    const int file = ::open(name, O_CREAT | O_WRONLY, 0666);
    if (file < 0) continue;
    ++made;
    ::close(file);
  }
  expect_refusal("files", made > 0);
}
