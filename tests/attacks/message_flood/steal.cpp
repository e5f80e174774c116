#include "paths.h"
#define A    \
  undefined; \
  undefined; \
  undefined; \
  undefined; \
  undefined; \
  undefined; \
  undefined;
#define B A A A A A A A A
#define C B B B B B B B B
#define D C C C C C C C C
#define E D D D D D D D D
void f() {
  E E
}
