#include "grader/run/result_reader.h"

#include <cstring>

namespace meshgrade {
namespace {

std::string_view next_frame(std::string_view& bytes) {
  std::uint64_t length = 0;
  if (bytes.size() < sizeof length) throw WireError("a frame without a length");
  std::memcpy(&length, bytes.data(), sizeof length);
  bytes.remove_prefix(sizeof length);
  if (length > bytes.size()) throw WireError("a frame longer than the file");
  const std::string_view frame = bytes.substr(0, static_cast<std::size_t>(length));
  bytes.remove_prefix(frame.size());
  return frame;
}

void check_end(const EndFrame& end) {
  if (static_cast<std::uint32_t>(end.ending) > kLastEnding) {
    throw WireError("an ending that does not exist");
  }
  if (end.stack.size() > kMostStackFrames || end.output.size() > kKeptOutputBytes) {
    throw WireError("more than the worker ever keeps");
  }
}

}  // namespace

std::vector<TaskResult> read_results(std::string_view bytes, std::size_t tasks) {
  std::vector<TaskResult> results(tasks);
  std::size_t current = 0;
  while (!bytes.empty()) {
    WireReader frame(next_frame(bytes));
    const auto kind = frame.read<FrameKind>();
    if (current >= tasks) throw WireError("more tasks than were given");
    if (kind == FrameKind::kStep) {
      StepFrame step = frame.read<StepFrame>();
      if (step.task != current) throw WireError("a step of another task");
      results[current].steps.push_back(std::move(step.result));
    } else if (kind == FrameKind::kEnd) {
      results[current].end = frame.read<EndFrame>();
      check_end(results[current].end);
      if (results[current].end.task != current) throw WireError("the end of another task");
      results[current].ended = true;
      ++current;
    } else {
      throw WireError("a frame of unknown kind");
    }
    frame.expect_end();
  }
  return results;
}

}  // namespace meshgrade
