#include "grader/base/cancel.h"

#include <atomic>

namespace meshgrade {
namespace {

std::atomic<int> cancellations{0};

}  // namespace

Cancellation::Cancellation() {
  ++cancellations;
}

Cancellation::~Cancellation() {
  --cancellations;
}

bool is_cancelled() {
  return cancellations > 0;
}

}  // namespace meshgrade
