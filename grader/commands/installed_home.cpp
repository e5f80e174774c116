#include "grader/commands/installed_home.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <set>
#include <system_error>

#include "grader/base/digest.h"
#include "grader/base/errors.h"
#include "grader/base/kept_files.h"
#include "grader/base/process_self.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/commands/kept_work.h"
#include "grader/sandbox/system_paths.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHeader = "precompiled.h";
constexpr const char* kPrecompiled = "precompiled.h.gch";
/// Written last. It holds the size of the precompiled headers: of a file that was cut off the
/// compiler would say that the student's code is at fault.
constexpr const char* kReady = "ready";

std::string from_environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// What tells whether a file is still the same, without reading it.
std::string stamp_of(const fs::path& file) {
  std::error_code ignored;
  const fs::path real = fs::canonical(file, ignored);
  return real.string() + " " + std::to_string(fs::file_size(real, ignored)) + " " +
         std::to_string(fs::last_write_time(real, ignored).time_since_epoch().count());
}

std::string name_of_kit(const fs::path& shipped, const fs::path& include,
                        const std::string& compiler) {
  Digest digest;
  digest.add(stamp_of(shipped / "libmeshgrade_worker.a"))
      .add(stamp_of(shipped / "flags.txt"))
      .add(stamp_of(include / "meshedit" / "halfedge_mesh.h"))
      .add(stamp_of(compiler));
  return "kit-" + digest.hex().substr(0, 16);
}

std::string size_text(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  return error ? "" : std::to_string(size);
}

bool is_ready(const fs::path& kit) {
  try {
    return is_only_mine(kit.parent_path()) && is_only_mine(kit) &&
           read_whole_file(kit / kReady) == size_text(kit / kPrecompiled);
  } catch (const UserError&) {
    return false;
  }
}

ProcessResult run_compiler(std::vector<std::string> arguments) {
  Command command;
  command.arguments = std::move(arguments);
  try {
    return run_process(command);
  } catch (const GraderError& error) {
    throw UserError(error.what());
  }
}

/// The kit was made by GCC, and some of its options are GCC's alone.
void fit_flags_to(const std::string& compiler, const fs::path& kit) {
  if (run_compiler({compiler, "--version"}).output.find("clang") == std::string::npos) return;
  static const std::set<std::string> only_gcc{"-fno-gnu-unique", "-ftrack-macro-expansion=0",
                                              "-static-libasan", "-static-libubsan"};
  for (const char* name : {"flags.txt", "flags_sanitize.txt", "flags_debug.txt"}) {
    std::string kept;
    for (const std::string& flag : split_lines(read_whole_file(kit / name))) {
      if (only_gcc.count(flag) == 0) kept += flag + "\n";
    }
    write_file_safely(kit / name, kept);
  }
}

/// No compiler for Meshgrade, wherever the headers are kept.
class UnfitCompiler : public UserError {
 public:
  using UserError::UserError;
};

void precompile(const std::string& compiler, const fs::path& include, const fs::path& kit) {
  const ProcessResult result =
      run_compiler({compiler, "@" + (kit / "flags.txt").string(), "-I" + include.string(), "-x",
                    "c++-header", kit / kHeader, "-o", kit / kPrecompiled});
  if (result.ok()) return;
  throw UnfitCompiler(compiler +
                      " cannot compile Meshgrade's headers: it takes GCC 11 or Clang 14, " +
                      "or later, with the C++ standard library. It said:\n" + result.output);
}

/// Everything but `ready`, in a folder that is new or empty.
void fill(const fs::path& kit, const fs::path& shipped, const fs::path& include,
          const std::string& compiler) {
  fs::copy(shipped, kit, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kit)) {
    fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
    fs::permissions(entry.path(), fs::perms::group_write | fs::perms::others_write,
                    fs::perm_options::remove);
  }
  fs::permissions(kit, fs::perms(0755));
  fit_flags_to(compiler, kit);
  precompile(compiler, include, kit);
}

void say_to_user(const std::string& text) {
  std::cerr << "meshgrade: " << printable(text) << "\n";
}

/// Only one call makes a kit at a time. It is made in its place, since Clang's precompiled
/// headers know where they lie; it is used when `ready` is there.
void keep_in(const fs::path& place, const fs::path& shipped, const fs::path& include,
             const std::string& compiler) {
  const FileDescriptor lock(
      ::open((place.parent_path() / "lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600));
  if (lock.get() >= 0) ::flock(lock.get(), LOCK_EX);
  if (is_ready(place)) return;
  fs::remove_all(place);
  fs::create_directory(place);
  fill(place, shipped, include, compiler);
  write_file_safely(place / kReady, size_text(place / kPrecompiled));
}

}  // namespace

fs::path installed_share() {
  std::error_code error;
  const fs::path program = program_file();
  if (program.empty()) return {};
  const fs::path share = program.parent_path().parent_path() / "share" / "meshgrade";
  return fs::is_directory(share / "kit", error) ? share : fs::path();
}

std::string installed_compiler() {
  std::string name = from_environment("CXX");
  name = name.substr(0, name.find(' '));
  if (name.empty()) name = "c++";
  const fs::path found = find_program(name);
  if (found.empty()) {
    throw UserError("there is no C++ compiler \"" + name +
                    "\" here. Install one (on Debian and Ubuntu: sudo apt-get install g++), or "
                    "name yours: CXX=clang++ meshgrade ...");
  }
  return found;
}

ReadyKit ready_kit(const fs::path& shipped, const fs::path& include,
                   const std::string& compiler) {
  const fs::path cache = cache_folder();
  const fs::path kept = cache / name_of_kit(shipped, include, compiler);
  if (is_ready(kept)) return {kept, nullptr};
  if (make_own_folder(cache)) {
    try {
      say_to_user("compiling the shared headers, once for this compiler");
      keep_in(kept, shipped, include, compiler);
      return {kept, nullptr};
    } catch (const UnfitCompiler&) {
      throw;
    } catch (const std::exception& error) {  // the disk is full, say
      say_to_user(std::string("the shared headers cannot be kept: ") + error.what());
    }
  } else {
    say_to_user("compiling the shared headers, which cannot be kept for the next call: " +
                (cache.empty()
                     ? "there is no home folder"
                     : cache.string() + " is no folder that you, and only you, can write to"));
  }
  ReadyKit kit{{}, std::make_shared<ScratchFolder>()};
  fs::permissions(kit.scratch->path(), fs::perms(0755));
  kit.folder = kit.scratch->path() / "kit";
  fs::create_directory(kit.folder);
  fill(kit.folder, shipped, include, compiler);
  return kit;
}

}  // namespace meshgrade
