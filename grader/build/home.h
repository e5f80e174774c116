#pragma once

#include <filesystem>

namespace meshgrade {

/// Where the program's own files are.
struct Home {
  std::filesystem::path include;  ///< the folder that holds meshedit/
  std::filesystem::path kit;      ///< compiler flags, precompiled headers, the worker's objects
  std::filesystem::path meshes;   ///< the meshes that cases are made from
  std::filesystem::path docs;
  /// The model solution, which stands in for what a submission lacks; empty in a package that
  /// comes without it.
  std::filesystem::path reference;
  std::string compiler;  ///< the C++ compiler for submissions
};

}  // namespace meshgrade
