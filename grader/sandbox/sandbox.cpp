#include "grader/sandbox/sandbox.h"

#include <sys/utsname.h>
#include <unistd.h>

#ifdef __linux__
#include <linux/seccomp.h>
#include <sys/syscall.h>
#endif

#include <cstdio>
#include <cstring>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/sandbox/confined_run.h"
#include "grader/sandbox/system_paths.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

#ifdef __linux__
Probe probe_landlock() {
  constexpr unsigned kAskForVersion = 1;
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, kAskForVersion);
  if (version > 0) return {"Landlock", true, "version " + std::to_string(version)};
  return {"Landlock", false, "this kernel does not offer it (Linux 5.13 and later can)"};
}

Probe probe_seccomp() {
  const unsigned action = SECCOMP_RET_ERRNO;
  const bool works = ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
  return {"seccomp", works, works ? "" : "this kernel does not offer it"};
}
#else
Probe probe_landlock() {
  return {"Landlock", false, "only Linux has it"};
}
Probe probe_seccomp() {
  return {"seccomp", false, "only Linux has it"};
}
#endif

Probe probe_bwrap(const fs::path& bwrap) {
  if (bwrap.empty()) return {"bubblewrap", false, "not installed: the package is bubblewrap"};
  return {"bubblewrap", true, bwrap.string()};
}

Probe probe_root() {
  const bool works = ::geteuid() == 0;
  return {"other user", works, works ? "" : "only root can start programs as another user"};
}

/// From Linux 5.14 on, the limit set in a user namespace counts what is in it.
bool namespaces_count_processes() {
  utsname name{};
  int major = 0;
  int minor = 0;
  if (::uname(&name) != 0 || std::sscanf(name.release, "%d.%d", &major, &minor) != 2) {
    return false;
  }
  return major > 5 || (major == 5 && minor >= 14);
}

/// Runs something small in this sandbox. @return why it does not work; empty if it does
std::string failure_of(const Sandbox& sandbox, const fs::path& kit,
                       const std::string& compiler) {
  try {
    const ScratchFolder folder;
    Command command;
    command.arguments = {"test", "-r", kit / "flags.txt", "-a", "-x", compiler};
    command.folder = folder.path();
    Bounds bounds;
    bounds.compiles = true;
    bounds.readable = {kit};
    const ProcessResult result = run_confined(sandbox, command, bounds);
    if (result.ok()) return {};
    return "in it, " + kit.string() + " or " + compiler + " is out of reach";
  } catch (const GraderError& error) {
    return error.what();
  }
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// Uses what there is for this layer.
Sandbox with_layer(Sandbox sandbox, Layer layer) {
  const bool root = ::geteuid() == 0;
  sandbox.layer = layer;
  sandbox.other_user = root && layer != Layer::kSameUser;
  sandbox.counts_processes =
      sandbox.other_user || (layer == Layer::kNamespaces && namespaces_count_processes());
  return sandbox;
}

/// @return why this layer is out of the question here; empty if it is not
std::string obstacle(const Sandbox& sandbox, Layer layer) {
  if (layer == Layer::kNamespaces && sandbox.bwrap.empty())
    return "bubblewrap is not installed";
  if (layer == Layer::kOtherUser && ::geteuid() != 0) return "this is not run by root";
  return {};
}

}  // namespace

Sandbox find_sandbox(const fs::path& kit, const std::string& compiler, Layer strongest) {
  Sandbox base;
  base.launcher = kit / "meshgrade-launcher";
  base.bwrap = find_program("bwrap");
  base.probes = {probe_bwrap(base.bwrap), probe_landlock(), probe_seccomp(), probe_root()};
  base.bounds_files = base.probes[1].works;
  base.filters_calls = base.probes[2].works;
  const fs::path unusual = unusual_folder_of(compiler);
  if (!unusual.empty()) base.readable.push_back(unusual);
  for (const Layer layer : {Layer::kNamespaces, Layer::kOtherUser, Layer::kSameUser}) {
    if (layer < strongest) continue;
    const Sandbox sandbox = with_layer(base, layer);
    std::string reason = obstacle(base, layer);
    if (reason.empty()) reason = first_line(failure_of(sandbox, kit, compiler));
    base.probes.push_back({"layer " + layer_name(layer), reason.empty(), reason});
    if (!reason.empty()) continue;
    Sandbox found = sandbox;
    found.probes = base.probes;
    return found;
  }
  return base;
}

std::string layer_name(Layer layer) {
  switch (layer) {
    case Layer::kNamespaces:
      return "1 (namespaces)";
    case Layer::kOtherUser:
      return "2 (another user)";
    case Layer::kSameUser:
      return "3 (limits)";
    case Layer::kNone:
      break;
  }
  return "none";
}

std::string layer_promise(Layer layer) {
  switch (layer) {
    case Layer::kNamespaces:
      return "student code sees only itself and the system's libraries: no other files, no "
             "network, no other processes";
    case Layer::kOtherUser:
      return "student code is a user that owns nothing: it cannot read or change what belongs "
             "to others, and all it leaves running is ended";
    case Layer::kSameUser:
      return "limits against accidents; student code runs with your own rights, so do not run "
             "code of strangers";
    case Layer::kNone:
      break;
  }
  return "nothing but a time limit; do not run code of strangers";
}

void require_sandbox(const Sandbox& sandbox) {
  if (sandbox.layer == Layer::kNamespaces || sandbox.layer == Layer::kOtherUser) return;
  std::string why;
  for (const Probe& probe : sandbox.probes) {
    if (!probe.works && probe.name.rfind("layer ", 0) == 0) {
      why += "; " + probe.name + ": " + probe.detail;
    }
  }
  throw UserError("--require-sandbox: this machine offers too little to run code of strangers" +
                  why + ". `meshgrade doctor` tells what would help");
}

}  // namespace meshgrade
