#include "CGL/renderer.h"
