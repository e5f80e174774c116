#include "grader/run/symbolizer.h"

#include <cstdlib>
#include <sstream>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/text.h"
#include "grader/sandbox/confined_run.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostMemory = std::uint64_t{1} << 31U;

/// "./edge_flip.cpp:12 (discriminator 3)"
void read_place(const std::string& text, StackFrame& frame) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return;
  frame.line = std::atoi(text.c_str() + colon + 1);
  frame.file = text.substr(0, colon);
  if (frame.file == "??") frame.file.clear();
}

}  // namespace

std::map<std::uint64_t, std::vector<StackFrame>> symbolize(
    const Build& build, const std::set<std::uint64_t>& addresses) {
  std::map<std::uint64_t, std::vector<StackFrame>> frames;
  if (addresses.empty()) return frames;
  const ScratchFolder folder;
  fs::create_hard_link(build.worker, folder.path() / "worker");
  Command command;
  command.arguments = {"addr2line", "-a", "-f", "-i", "-C", "-e", "worker"};
  command.folder = folder.path();
  std::ostringstream input;
  for (std::uint64_t address : addresses)
    input << std::hex << address << "\n";
  command.input = input.str();
  command.kept_output = 16U << 20U;
  // The student's code has a say in what is read here.
  Bounds bounds;
  bounds.compiles = true;
  bounds.memory_bytes = kMostMemory;
  ProcessResult result;
  try {
    result = run_confined(build.sandbox, std::move(command), bounds);
  } catch (const GraderError&) {
    return frames;  // not installed
  }
  if (!result.ok()) return frames;
  std::vector<StackFrame>* current = nullptr;
  const std::vector<std::string> lines = split_lines(printable(result.output));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].rfind("0x", 0) == 0) {
      current = &frames[std::strtoull(lines[i].c_str(), nullptr, 16)];
    } else if (current != nullptr && i + 1 < lines.size()) {
      StackFrame frame{lines[i], "", 0};
      read_place(lines[++i], frame);
      current->push_back(std::move(frame));
    }
  }
  return frames;
}

}  // namespace meshgrade
