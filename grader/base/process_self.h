#pragma once

#include <filesystem>

namespace meshgrade {

/// The file of the running program; empty if the system does not tell.
std::filesystem::path program_file();

}  // namespace meshgrade
