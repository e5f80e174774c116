#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meshgrade {

/// What every program needs to read: its libraries. With `compiles` also the headers, and the
/// programs that a compiler consists of. Nothing where an instructor could have files.
std::vector<std::filesystem::path> system_paths(bool compiles);

/// The programs by which the kernel loads another one. They lie in system_paths().
std::vector<std::filesystem::path> loaders();

/// The devices that a program may use.
std::vector<std::filesystem::path> harmless_devices();

/// The folder that has to be readable besides the system's own for this program to start; empty
/// if there is none.
std::filesystem::path unusual_folder_of(const std::string& program);

/// Whether other users can read this file or enter this folder, and all folders on the way.
bool is_open_to_others(const std::filesystem::path& path);

/// Where a program is found; empty if it is not on the PATH.
std::filesystem::path find_program(const std::string& name);

}  // namespace meshgrade
