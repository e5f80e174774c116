#include "grader/base/process_tree.h"

#include <dirent.h>
#include <sys/stat.h>

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace meshgrade {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

struct CloseFolder {
  void operator()(DIR* folder) const { ::closedir(folder); }
};

/// Calls `read` with each line of what the system says of a process.
/// @param process  its folder in /proc
template <class Read>
void read_status(const std::string& process, Read read) {
  const File status(std::fopen((process + "/status").c_str(), "re"));
  char line[256];
  while (status != nullptr && std::fgets(line, sizeof line, status.get()) != nullptr)
    read(line);
}

/// Bytes of memory that belong to no file, as far as they are in real memory.
std::uint64_t own_memory(const std::string& process) {
  std::uint64_t kilobytes = 0;
  read_status(process, [&](const char* line) {
    unsigned long long value = 0;
    if (std::sscanf(line, "RssAnon: %llu", &value) == 1 ||
        std::sscanf(line, "RssShmem: %llu", &value) == 1) {
      kilobytes += value;
    }
  });
  return kilobytes * 1024;
}

void add_children(const std::string& thread, std::vector<pid_t>& processes) {
  const File children(std::fopen((thread + "/children").c_str(), "re"));
  int child = 0;
  while (children != nullptr && std::fscanf(children.get(), "%d", &child) == 1)
    processes.push_back(child);
}

}  // namespace

TreeUse use_of_tree(pid_t root) {
  constexpr std::size_t kMostProcesses = 10'000;  // more need not be counted
  TreeUse use;
  std::vector<pid_t> waiting{root};
  while (!waiting.empty() && use.processes < kMostProcesses) {
    const std::string process = "/proc/" + std::to_string(waiting.back());
    waiting.pop_back();
    use.memory += own_memory(process);
    const std::string threads = process + "/task";
    const std::unique_ptr<DIR, CloseFolder> folder(::opendir(threads.c_str()));
    if (folder == nullptr) continue;
    while (const dirent* entry = ::readdir(folder.get())) {
      if (entry->d_name[0] == '.') continue;
      ++use.processes;
      add_children(threads + "/" + entry->d_name, waiting);
    }
  }
  return use;
}

std::size_t processes_of_user(uid_t user) {
  std::size_t count = 0;
  const std::unique_ptr<DIR, CloseFolder> folder(::opendir("/proc"));
  while (const dirent* entry = folder == nullptr ? nullptr : ::readdir(folder.get())) {
    if (std::isdigit(static_cast<unsigned char>(entry->d_name[0])) == 0) continue;
    // Whose a process is tells the owner of its folder, at a hundredth of what its status
    // costs.
    struct stat owned {};
    if (::fstatat(::dirfd(folder.get()), entry->d_name, &owned, 0) != 0) continue;
    if (owned.st_uid != user) continue;
    read_status(std::string("/proc/") + entry->d_name, [&](const char* line) {
      std::size_t threads = 0;
      if (std::sscanf(line, "Threads: %zu", &threads) == 1) count += threads;
    });
  }
  return count;
}

}  // namespace meshgrade
