#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/batch/result_store.h"

namespace meshgrade {

/// Where the tasks of a cluster find what to do and leave what they did: a folder within that
/// of the results. A task grades a list of hand-ins as a batch of its own, in a folder that no
/// other task writes to, not even a second run of the same task. So it does no harm when a task
/// runs twice, or stops anywhere; what counts is taken over here, by whoever started them.
class TaskFolder {
 public:
  /// @param results  the folder of the whole batch
  explicit TaskFolder(const std::filesystem::path& results);

  /// Divides hand-ins into lists for tasks, and writes the lists.
  /// @return how many there are; they count from 0
  /// @throws UserError if they cannot be written
  std::size_t write_lists(const std::string& round, const std::vector<std::string>& keys,
                          std::size_t per_task) const;

  /// The list of a task, without its number and ".txt".
  std::filesystem::path list_stem(const std::string& round) const;
  /// The folder of a task's results, without its number and what tells its runs apart.
  std::filesystem::path result_stem(const std::string& round) const;

  /// Takes over the results that tasks have finished, and that are of the wanted version.
  /// @param wanted  key and fingerprint of the hand-ins that are still to come
  /// @return the keys of those taken over
  std::vector<std::string> collect(const std::map<std::string, std::string>& wanted,
                                   const ResultStore& store) const;

  /// The job that works for this folder, so that a later call finds it; empty if there is none.
  std::string job() const;
  void remember_job(const std::string& job) const;

  const std::filesystem::path& path() const { return folder_; }
  void remove() const;

 private:
  std::filesystem::path folder_;
};

/// The keys in a list.
/// @throws UserError if it cannot be read
std::vector<std::string> read_task_list(const std::filesystem::path& file);

}  // namespace meshgrade
