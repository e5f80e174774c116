#include "paths.h"
#if __has_include(SECRET_FILE)
#error BREACH: it is there
#endif
#if __has_include(PROJECT "/reference/vertex_normal.cpp")
#error BREACH: the reference
#endif
