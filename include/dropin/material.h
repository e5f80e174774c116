#pragma once

#include "course.h"
