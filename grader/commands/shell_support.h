#pragma once

#include <string>

namespace CLI {
class App;
}

namespace meshgrade {

/// A script by which a shell completes commands and options, made from what the program itself
/// understands.
/// @param shell  "bash", "zsh" or "fish"
std::string completions_for(const std::string& shell, const CLI::App& app);

/// The manual page, in the language of man(7).
std::string manual_page(const CLI::App& app, const std::string& version);

}  // namespace meshgrade
