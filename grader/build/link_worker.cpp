#include "grader/build/link_worker.h"

#include <filesystem>

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// Makes one object of many, lets go of all their symbols but those of the course, and links.
/// One program for the sandbox, which takes as long to start as two of the three steps.
constexpr const char* kMergeAndLink = R"(compiler=$1 kit=$2 flags=$3 driver=$4 worker=$5
shift 5
"$compiler" "@$kit/merge.txt" -o merged.o "$@" &&
  objcopy "@$kit/localise.txt" merged.o submission.o &&
  exec "$compiler" "$flags" -no-pie -o "$worker" submission.o ${driver:+"$driver"} \
    "$kit/libmeshgrade_worker.a")";

}  // namespace

ProcessResult link_worker(const Workshop& workshop, const Home& home, const std::string& flags,
                          const WorkerParts& parts) {
  const bool merges = !parts.objects.empty() && fs::exists(home.kit / "merge.txt");
  std::vector<std::string> arguments;
  if (merges) {
    for (const char* made : {"merged.o", "submission.o"})
      fs::remove(workshop.folder() / made);  // another user may own it
    arguments = {"sh",     "-c",  kMergeAndLink, "link",      home.compiler,
                 home.kit, flags, parts.driver,  parts.worker};
  } else {
    arguments = {home.compiler, flags, "-no-pie", "-o", parts.worker};
  }
  arguments.insert(arguments.end(), parts.objects.begin(), parts.objects.end());
  if (!merges) {
    if (!parts.driver.empty()) arguments.push_back(parts.driver);
    arguments.push_back(home.kit / "libmeshgrade_worker.a");
  }
  return workshop.run(std::move(arguments), parts.worker);
}

}  // namespace meshgrade
