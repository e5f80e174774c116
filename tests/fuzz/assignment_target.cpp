// Fuzz target of the assignment reader.

#include <string>

#include "grader/assignment/assignment.h"
#include "grader/base/errors.h"
#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    meshgrade::parse_assignment(text, "assignment.toml");
  } catch (const meshgrade::UserError&) {
    // what its contract allows
  }
  return 0;
}
