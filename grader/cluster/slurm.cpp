#include "grader/cluster/slurm.h"

#include <algorithm>
#include <cctype>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace {

ProcessResult call(std::vector<std::string> arguments) {
  Command command;
  command.arguments = std::move(arguments);
  return run_process(command);
}

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(),
                                      [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

std::string submit(const ArrayJob& job) {
  std::vector<std::string> arguments{
      "sbatch",
      "--parsable",
      "--requeue",
      "--job-name=meshgrade",
      "--array=0-" + std::to_string(job.tasks - 1),
      "--cpus-per-task=" + std::to_string(job.cpus_per_task),
      "--output=" + (job.logs / "%A-%a.txt").string(),
  };
  arguments.insert(arguments.end(), job.options.begin(), job.options.end());
  arguments.push_back(job.script.string());
  ProcessResult result;
  try {
    result = call(arguments);
  } catch (const GraderError&) {
    throw UserError(
        "there is no sbatch here; call this on a machine of a Slurm cluster, or use " +
        std::string("--jobs-file with another scheduler"));
  }
  // "123", or "123;cluster"; warnings may come before it.
  const std::vector<std::string> lines = split_lines(result.output);
  const std::string last = lines.empty() ? "" : lines.back();
  std::string number = last.substr(0, last.find(';'));
  if (!result.ok() || !is_number(number)) {
    throw UserError("sbatch refused the job: " + printable(result.output));
  }
  return number;
}

std::optional<std::size_t> tasks_left(const std::string& job) {
  const ProcessResult result =
      call({"squeue", "--noheader", "--array", "--format=%t", "--jobs=" + job});
  if (result.ok()) {
    const std::vector<std::string> lines = split_lines(result.output);
    return std::count_if(lines.begin(), lines.end(),
                         [](const std::string& line) { return !line.empty(); });
  }
  // Slurm forgets a job some minutes after its end.
  if (result.output.find("Invalid job id") != std::string::npos) return 0;
  return std::nullopt;
}

void cancel(const std::string& job) {
  call({"scancel", job});
}

}  // namespace meshgrade
