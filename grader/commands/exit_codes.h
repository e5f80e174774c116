#pragma once

namespace meshgrade {

/// What the program ends with, beside 0 for "all fine" and 1 for "something was found".
constexpr int kUserError = 2;
constexpr int kGraderFailed = 3;

}  // namespace meshgrade
