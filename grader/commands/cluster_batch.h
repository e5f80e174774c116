#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/batch/batch.h"

namespace meshgrade {

/// How a class is divided among machines.
struct ClusterOptions {
  bool slurm = false;
  std::vector<std::string> sbatch;  ///< more options for sbatch
  std::size_t per_task = 16;        ///< hand-ins
  std::string jobs_file;            ///< only write the commands to this file

  bool wanted() const { return slurm || !jobs_file.empty(); }
};

/// What a batch on a cluster works with.
struct ClusterBatch {
  const Roster& roster;
  const Grading& grading;
  const BatchFolder& folder;
  const BatchOptions& how;
  const ClusterOptions& cluster;
  /// The command of a task, but for -o and --only-file.
  std::vector<std::string> command;
};

/// Takes over what tasks of an earlier call have finished, if there is any.
/// @throws UserError if the results cannot be written
void collect_finished_tasks(const ClusterBatch& batch);

/// Grades by an array job of Slurm: submits it, follows it, takes the results over as they
/// come, and submits again what went missing on lost nodes. A job that an earlier call has
/// submitted is followed to its end first.
/// @return false if it was stopped: the job is cancelled then
/// @throws UserError if there is no Slurm, or hand-ins stay without a result
bool run_on_slurm(const ClusterBatch& batch);

/// Writes one command a line, for any scheduler; the next call collects what they did.
/// @return how many commands there are
/// @throws UserError if it cannot be written
std::size_t write_jobs_file(const ClusterBatch& batch);

}  // namespace meshgrade
