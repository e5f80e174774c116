#include "grader/sandbox/launcher/options.h"

#include <cerrno>
#include <cstring>
#include <map>

namespace meshgrade::launcher {
namespace {

std::uint64_t number(const std::string& option, const std::string& text) {
  try {
    std::size_t used = 0;
    const std::uint64_t value = std::stoull(text, &used);
    if (used == text.size() && text[0] != '-') return value;
  } catch (const std::logic_error&) {
    // falls through to the refusal
  }
  throw Refusal(option + " needs a number, not \"" + text + "\"");
}

bool set_number(Options& options, const std::string& option, const std::string& value) {
  const std::map<std::string, std::optional<std::uint64_t> Options::*> numbers{
      {"--report", &Options::report},        {"--user", &Options::user},
      {"--cpu", &Options::cpu_seconds},      {"--memory", &Options::memory_bytes},
      {"--file", &Options::file_bytes},      {"--processes", &Options::processes},
      {"--open-files", &Options::open_files}};
  const auto found = numbers.find(option);
  if (found == numbers.end()) return false;
  options.*found->second = number(option, value);
  return true;
}

bool set_word(Options& options, const std::string& option, const std::string& value) {
  if (option == "--read")
    options.read.push_back(value);
  else if (option == "--run")
    options.run.push_back(value);
  else if (option == "--write")
    options.write.push_back(value);
  else if (option == "--supervise" && value == "yes")
    options.supervise = true;
  else if (option == "--signals" && value == "own")
    options.own_signals = true;
  else if (option == "--calls" && value == "few")
    options.few_calls = true;
  else
    return false;
  return true;
}

}  // namespace

void refuse(const std::string& what) {
  throw Refusal(what + ": " + std::strerror(errno));
}

Options read_options(int argc, char** argv) {
  Options options;
  int i = 1;
  for (; i + 1 < argc && std::strcmp(argv[i], "--") != 0; i += 2) {
    if (!set_number(options, argv[i], argv[i + 1]) &&
        !set_word(options, argv[i], argv[i + 1])) {
      throw Refusal(std::string("unknown option ") + argv[i] + " " + argv[i + 1]);
    }
  }
  if (i + 1 >= argc) throw Refusal("no program is named after --");
  options.program.assign(argv + i + 1, argv + argc);
  options.program.push_back(nullptr);
  return options;
}

}  // namespace meshgrade::launcher
