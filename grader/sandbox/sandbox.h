#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meshgrade {

/// How student code and the compiler that reads it are kept away from everything else, the
/// strongest way first.
enum class Layer {
  kNamespaces = 1,  ///< nothing but what it needs is there at all (bubblewrap)
  kOtherUser = 2,   ///< a user of its own that may do nothing
  kSameUser = 3,    ///< limits only: against accidents, not against intent
  kNone = 4,        ///< a time limit, and what the worker asks of itself
};

/// One thing that was tried on this machine.
struct Probe {
  std::string name;  ///< "Landlock"
  bool works = false;
  std::string detail;  ///< a version, or why it does not work
};

/// What this machine offers. Made once, by find_sandbox(), and passed on as a value.
struct Sandbox {
  Layer layer = Layer::kNone;
  bool other_user = false;        ///< each run is a user of its own (needs root)
  bool bounds_files = false;      ///< Landlock
  bool filters_calls = false;     ///< seccomp
  bool counts_processes = false;  ///< the system's own limit counts this run's processes only
  std::filesystem::path launcher;
  std::filesystem::path bwrap;
  std::vector<std::filesystem::path> readable;  ///< the compiler's folder, if it is unusual
  std::vector<Probe> probes;
};

/// Tries what works, the strongest layer first.
/// @param kit        the folder of the launcher; the run must be able to read it
/// @param compiler   must be able to start
/// @param strongest  no layer above this one is tried
Sandbox find_sandbox(const std::filesystem::path& kit, const std::string& compiler,
                     Layer strongest = Layer::kNamespaces);

/// "1 (namespaces)"
std::string layer_name(Layer layer);

/// What this layer protects against, in one sentence for an instructor.
std::string layer_promise(Layer layer);

/// For grading strangers.
/// @throws UserError that says why, unless the layer is kNamespaces or kOtherUser
void require_sandbox(const Sandbox& sandbox);

}  // namespace meshgrade
