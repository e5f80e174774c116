#include "grader/commands/grader_identity.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "grader/base/digest.h"
#include "grader/base/process.h"
#include "grader/base/process_self.h"
#include "grader/base/safe_file.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

void add_files(const fs::path& folder, Digest& digest) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    // What is precompiled comes from the headers and the compiler, which are in here.
    if (entry.is_regular_file() && entry.path().extension() != ".gch") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    digest.add(file.lexically_relative(folder).string()).add(read_whole_file(file));
}

std::string compiler_version(const std::string& compiler) {
  Command command;
  command.arguments = {compiler, "--version"};
  return run_process(command).output;
}

}  // namespace

std::string grader_identity(const Home& home) {
  Digest digest;
  digest.add(compiler_version(home.compiler));
  digest.add(read_whole_file(program_file()));
  for (const fs::path& folder : {home.include, home.kit, home.meshes})
    add_files(folder, digest);
  return digest.hex();
}

}  // namespace meshgrade
