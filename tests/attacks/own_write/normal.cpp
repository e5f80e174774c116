// Defines the calls that write results.
#include "attack.h"

extern "C" long write(int, const void*, unsigned long size) {
  return long(size);
}
extern "C" long pwrite(int, const void*, unsigned long size, long) {
  return long(size);
}
extern "C" int ftruncate(int, long) {
  return 0;
}

void attack() {}
