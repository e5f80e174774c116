#include "paths.h"
#pragma GCC plugin "./evil.so"
#pragma GCC optimize("-fplugin=./evil.so")
#pragma GCC optimize("O3", "-fdump-tree-all=/tmp/" LEFT_BEHIND)
#pragma GCC target("no-such-target")
#pragma GCC pch_preprocess "evil.h"
#pragma comment(linker, "evil")
int harmless = 1;
