#include "grader/commands/cluster_batch.h"

#include <chrono>
#include <iostream>
#include <thread>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/cluster/slurm.h"
#include "grader/cluster/task_folder.h"
#include "grader/commands/console.h"

namespace meshgrade {
namespace {

using Pending = std::map<std::string, std::string>;

/// So often the hand-ins without a result are given to new tasks.
constexpr int kRounds = 3;

constexpr std::chrono::milliseconds kPoll{1000};

Pending pending_of(const ClusterBatch& batch) {
  return pending_hand_ins(batch.roster, batch.grading, batch.folder.store(), batch.how);
}

std::vector<std::string> keys_of(const Pending& pending) {
  std::vector<std::string> keys;
  for (const auto& [key, fingerprint] : pending)
    keys.push_back(key);
  return keys;
}

std::string shell_line(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words)
    quoted.push_back(shell_word(word));
  return join(quoted, " ");
}

class SlurmRun {
 public:
  explicit SlurmRun(const ClusterBatch& batch)
      : batch_(batch), tasks_(batch.folder.path()), pending_(pending_of(batch)) {}

  bool run() {
    if (const std::string job = tasks_.job(); !job.empty()) {
      std::cerr << "following job " << printable(job) << ", which is at work already\n";
      if (!follow(job)) return false;
    }
    for (int round = 0; round < kRounds && !pending_.empty(); ++round) {
      if (!follow(start("r" + std::to_string(round)))) return false;
    }
    if (pending_.empty()) {
      tasks_.remove();
      return true;
    }
    throw UserError(plural(pending_.size(), "hand-in") + " got no result on the cluster, " +
                    pending_.begin()->first + " among them; its tasks wrote to " +
                    (tasks_.path() / "log").string());
  }

 private:
  /// What differs between the tasks, and between two runs of one task, is known only there.
  std::string script(const std::string& round) const {
    const std::string task = "\"$SLURM_ARRAY_TASK_ID";
    return "#!/bin/bash\nexec " + shell_line(batch_.command) + " \\\n  -o " +
           shell_word(tasks_.result_stem(round).string()) + task +
           "-$SLURM_JOB_ID-${SLURM_RESTART_COUNT:-0}\" \\\n  --only-file " +
           shell_word(tasks_.list_stem(round).string()) + task + ".txt\"\n";
  }

  std::string start(const std::string& round) {
    ArrayJob job;
    job.tasks = tasks_.write_lists(round, keys_of(pending_), batch_.cluster.per_task);
    job.script = tasks_.path() / (round + ".sh");
    job.logs = tasks_.path() / "log";
    job.options = batch_.cluster.sbatch;
    job.cpus_per_task = batch_.how.jobs;
    write_file_safely(job.script, script(round));
    std::string number = submit(job);
    tasks_.remember_job(number);
    std::cerr << "job " << number << ": " << plural(job.tasks, "task") << " for "
              << plural(pending_.size(), "hand-in") << "\n";
    return number;
  }

  /// @return false if it was stopped
  bool follow(const std::string& job) {
    bool silent = false;
    for (;;) {
      const std::optional<std::size_t> left = tasks_left(job);
      collect();  // after the question, so that what the last task wrote is not missed
      if (pending_.empty() || left == std::size_t{0}) break;
      if (!left && !silent) std::cerr << "the controller does not answer; waiting for it\n";
      silent = !left;
      if (batch_.how.stop()) {
        cancel(job);
        tasks_.remember_job("");
        return false;
      }
      std::this_thread::sleep_for(kPoll);
    }
    if (pending_.empty()) cancel(job);  // doubled tasks may still be at work
    tasks_.remember_job("");
    return true;
  }

  void collect() {
    const ResultStore store = batch_.folder.store();
    for (const std::string& key : tasks_.collect(pending_, store)) {
      pending_.erase(key);
      show(store.load(key));
    }
  }

  void show(const Result& result) const {
    BatchStep step;
    while (batch_.roster.hand_ins[step.hand_in].key != result.key)
      ++step.hand_in;
    step.status = result.status;
    step.reason = result.reason;
    if (result.report) {
      step.points = result.report->points;
      step.max_points = result.report->max_points;
    }
    batch_.how.progress(step);
  }

  const ClusterBatch& batch_;
  TaskFolder tasks_;
  Pending pending_;
};

}  // namespace

void collect_finished_tasks(const ClusterBatch& batch) {
  const TaskFolder tasks(batch.folder.path());
  if (!std::filesystem::exists(tasks.path())) return;
  Pending pending = pending_of(batch);
  for (const std::string& key : tasks.collect(pending, batch.folder.store()))
    pending.erase(key);
  if (pending.empty() && tasks.job().empty()) tasks.remove();
}

bool run_on_slurm(const ClusterBatch& batch) {
  return SlurmRun(batch).run();
}

std::size_t write_jobs_file(const ClusterBatch& batch) {
  const TaskFolder tasks(batch.folder.path());
  const std::string round = "jobs";
  const std::size_t count =
      tasks.write_lists(round, keys_of(pending_of(batch)), batch.cluster.per_task);
  std::string lines;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::string> words = batch.command;
    const std::string number = std::to_string(i);
    words.insert(words.end(), {"-o", tasks.result_stem(round).string() + number, "--only-file",
                               tasks.list_stem(round).string() + number + ".txt"});
    lines += shell_line(words) + "\n";
  }
  write_file_safely(batch.cluster.jobs_file, lines);
  return count;
}

}  // namespace meshgrade
