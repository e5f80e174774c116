#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "grader/base/errors.h"
#include "grader/files/mesh_file.h"

namespace meshgrade {

/// A test with a folder of its own, which is gone afterwards.
class ScratchFolder : public testing::Test {
 protected:
  ScratchFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("meshgrade_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~ScratchFolder() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path(name), std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path(name);
  }

  std::filesystem::path folder_;
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
