#include "grader/cluster/task_folder.h"

#include <algorithm>
#include <system_error>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace fs = std::filesystem;

TaskFolder::TaskFolder(const fs::path& results) : folder_(fs::absolute(results) / ".tasks") {}

std::size_t TaskFolder::write_lists(const std::string& round,
                                    const std::vector<std::string>& keys,
                                    std::size_t per_task) const {
  make_folder(folder_ / "lists");
  make_folder(folder_ / "results");
  make_folder(folder_ / "log");
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < keys.size(); begin += per_task) {
    std::string text;
    for (std::size_t i = begin; i < std::min(keys.size(), begin + per_task); ++i)
      text += keys[i] + "\n";
    write_file_safely(list_stem(round).string() + std::to_string(number++) + ".txt", text);
  }
  return number;
}

fs::path TaskFolder::list_stem(const std::string& round) const {
  return folder_ / "lists" / (round + "-");
}

fs::path TaskFolder::result_stem(const std::string& round) const {
  return folder_ / "results" / (round + "-");
}

std::vector<std::string> TaskFolder::collect(const std::map<std::string, std::string>& wanted,
                                             const ResultStore& store) const {
  std::vector<std::string> taken;
  std::error_code error;
  for (fs::directory_iterator task(folder_ / "results", error), end; !error && task != end;
       task.increment(error)) {
    const ResultStore finished = result_store(task->path());
    std::error_code none;
    for (fs::directory_iterator one(finished.folder(), none); !none && one != end;
         one.increment(none)) {
      const std::string key = finished.key_in(one->path());
      const auto want = wanted.find(key);
      if (want == wanted.end() || std::find(taken.begin(), taken.end(), key) != taken.end() ||
          finished.load(key).fingerprint != want->second) {
        continue;
      }
      store.take_over(finished, key);
      taken.push_back(key);
    }
  }
  return taken;
}

std::string TaskFolder::job() const {
  std::error_code error;
  if (!fs::exists(folder_ / "job", error)) return {};
  std::string text = read_whole_file(folder_ / "job");
  text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
  return text;
}

void TaskFolder::remember_job(const std::string& job) const {
  write_file_safely(folder_ / "job", job + "\n");
}

void TaskFolder::remove() const {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::vector<std::string> read_task_list(const fs::path& file) {
  std::vector<std::string> keys;
  for (const std::string& line : split_lines(read_whole_file(file))) {
    if (!line.empty()) keys.push_back(line);
  }
  return keys;
}

}  // namespace meshgrade
