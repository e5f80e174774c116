#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meshgrade {

/// An array job: the same script once for each number from 0 on, in SLURM_ARRAY_TASK_ID.
struct ArrayJob {
  std::filesystem::path script;
  std::size_t tasks = 0;
  unsigned cpus_per_task = 1;
  std::filesystem::path logs;        ///< a folder; each task writes a file there
  std::vector<std::string> options;  ///< more for sbatch: "--partition=long"
};

/// Submits it to the Slurm cluster of this machine.
/// @return its number
/// @throws UserError if there is no Slurm here, or it refuses the job
std::string submit(const ArrayJob& job);

/// How many of its tasks wait or run; nothing if the controller gives no answer now.
std::optional<std::size_t> tasks_left(const std::string& job);

void cancel(const std::string& job);

}  // namespace meshgrade
