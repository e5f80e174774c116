#pragma once

namespace meshgrade {

/// What the commands that grade say about --require-sandbox.
constexpr const char* kRequireSandboxHelp =
    "Refuse to run code of strangers where it cannot be kept away from everything else (see "
    "meshgrade doctor)";

}  // namespace meshgrade
