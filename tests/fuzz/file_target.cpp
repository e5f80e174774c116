// Fuzz target of the readers of files. Compiled once for each format, with its extension in
// MESHGRADE_FUZZ_EXTENSION.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "grader/base/errors.h"
#include "grader/files/bezier_file.h"
#include "grader/files/mesh_file.h"
#include "tests/fuzz/targets.h"

namespace {

namespace fs = std::filesystem;

const std::string kExtension = MESHGRADE_FUZZ_EXTENSION;

/// One file for all runs, in memory where the system has a place for that.
fs::path scratch_file() {
  const fs::path memory = "/dev/shm";
  const fs::path folder = fs::is_directory(memory) ? memory : fs::temp_directory_path();
  std::string name = (folder / "meshgrade-fuzz-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) std::abort();
  return fs::path(name) / ("input" + kExtension);
}

/// Removes the file at the end of the program.
struct Scratch {
  fs::path file = scratch_file();
  Scratch() = default;
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(file.parent_path(), ignored);
  }
};

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::cerr << "broken promise: " << what << "\n";
  std::abort();
}

void read(const fs::path& file) {
  if (kExtension == ".bez") {
    meshgrade::read_bez(file);
  } else if (kExtension == ".bzc") {
    require(meshgrade::read_bzc(file).size() >= 2, "a curve has at least 2 points");
  } else {
    const meshgrade::PolygonMesh mesh = meshgrade::read_mesh(file).mesh;
    require(!mesh.polygons.empty(), "a mesh has at least one polygon");
    for (const auto& polygon : mesh.polygons) {
      require(polygon.size() >= 3, "a polygon has at least 3 corners");
      for (const auto corner : polygon)
        require(corner < mesh.positions.size(), "every corner exists");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Scratch scratch;
  std::ofstream(scratch.file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    read(scratch.file);
  } catch (const meshgrade::UserError& error) {
    const std::string message = error.what();
    require(message.find('\n') == std::string::npos, "a message is one line: " + message);
  }
  return 0;
}
