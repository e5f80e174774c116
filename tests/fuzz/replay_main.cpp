// Feeds a fuzz target with every file of its corpus, and with mutations of each that are the
// same in every run.
//
//   fuzz_obj <corpus folder> [mutations of each file]

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/fuzz/targets.h"

namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

void feed(const std::string& bytes) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

/// Changes, removes, doubles or cuts off a few bytes.
std::string mutated(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return std::size_t{random()} % n; };
  for (std::size_t changes = 1 + below(4); changes > 0 && !bytes.empty(); --changes) {
    const std::size_t at = below(bytes.size());
    const std::size_t length = std::min(1 + below(16), bytes.size() - at);
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        bytes[at] = "0123456789-.e \n/"[below(16)];
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.substr(at, length));
        break;
      default:
        if (below(8) == 0) bytes.resize(at);
    }
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: " << argv[0] << " CORPUS [MUTATIONS]\n";
    return 2;
  }
  const int mutations = argc > 2 ? std::atoi(argv[2]) : 100;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(argv[1]))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::mt19937 random(184);
  for (const fs::path& file : files) {
    const std::string bytes = read_file(file);
    std::cout << file.filename().string() << std::endl;  // the last one is to blame for a crash
    feed(bytes);
    for (int i = 0; i < mutations; ++i)
      feed(mutated(bytes, random));
  }
  std::cout << files.size() << " files with " << mutations << " mutations each\n";
  return files.empty() ? 1 : 0;
}
