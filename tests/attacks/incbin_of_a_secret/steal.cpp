#include "paths.h"
asm(".section .data\nstolen: .incbin \"" SECRET_FILE "\"\n.byte 0\n.text\n");
extern "C" char stolen[];
#include <cstdio>
namespace {
const int early = std::puts(stolen);
}
