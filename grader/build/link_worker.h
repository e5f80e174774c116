#pragma once

#include <string>
#include <vector>

#include "grader/base/process.h"
#include "grader/build/home.h"
#include "grader/build/workshop.h"

namespace meshgrade {

/// What a worker is linked of, as files of a workshop.
struct WorkerParts {
  std::vector<std::string> objects;  ///< of the submission
  std::string driver;                ///< in place of that of the worker's library; empty: none
  std::string worker;                ///< to make
};

/// Links a worker. What the student's files define besides functions of the course is theirs
/// alone: malloc, write or main cannot be replaced.
/// @param flags  of the compiler, as it takes them
/// @return what the compiler, objcopy and the linker have said
ProcessResult link_worker(const Workshop& workshop, const Home& home, const std::string& flags,
                          const WorkerParts& parts);

}  // namespace meshgrade
