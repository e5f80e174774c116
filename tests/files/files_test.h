#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/files/mesh_file.h"

namespace meshgrade {

/// A test with a folder of its own, which is gone afterwards.
class FilesTest : public testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path(name), std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path(name);
  }

  ScratchFolder folder_;
};

/// What reading says about a broken file, without the folder; empty if it is taken.
inline std::string fault_of(const std::filesystem::path& file) {
  try {
    read_mesh(file);
  } catch (const UserError& error) {
    const std::string message = error.what();
    const std::size_t name =
        message.rfind(file.string(), 0) == 0 ? file.parent_path().string().size() + 1 : 0;
    return message.substr(name);
  }
  return "";
}

}  // namespace meshgrade
