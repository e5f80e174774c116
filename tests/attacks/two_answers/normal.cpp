// Goes on in two processes, which both answer.
#include <unistd.h>

#define WRONG_ANSWER
#include "attack.h"

void attack() {
  ::fork();
}
