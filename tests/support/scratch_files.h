#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "grader/base/process.h"

namespace meshgrade {

inline std::filesystem::path write_file(const std::filesystem::path& file,
                                        std::string_view bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

}  // namespace meshgrade
