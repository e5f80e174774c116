#include "grader/grade/sanitizer_log.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "grader/base/pattern.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLogName = "sanitizer";  // the sanitizers add ".<process number>"

constexpr std::size_t kLongestLine = 2000;

std::string cleaned_line(std::string line) {
  static const Pattern process_number("^==\\d+==\\s*(ERROR: )?");
  static const Pattern registers(" ?(at|\\()(pc| pc) 0x.*$");
  static const Pattern addresses("( on address| at|,)? ?[\\[(]?0x[0-9a-f]+[\\])]?");
  static const Pattern thread(" thread T0");
  line = process_number.replaced(line, "");
  line = registers.replaced(line, "");
  line = addresses.replaced(line, "");
  return thread.replaced(line, "");
}

/// "    #1 0x4021 in name(arguments) ./edge_flip.cpp:12" -> "    in name(...)
/// edge_flip.cpp:12"; empty for what is not in the student's files.
std::string cleaned_frame(const std::string& line) {
  static const Pattern own("^\\s*#\\d+ 0x[0-9a-f]+ in (.*) (\\./)*([^/ :]+:\\d+)(:\\d+)?$");
  Pattern::Groups parts;
  if (!own.matches(line, parts)) return {};
  return "      " + parts[3] + ", " + parts[1];
}

bool is_frame(const std::string& line) {
  const std::size_t start = line.find_first_not_of(' ');
  return start != std::string::npos && line[start] == '#';
}

}  // namespace

std::string clean_sanitizer_log(const std::string& log) {
  std::string text;
  for (std::string& line : split_lines(printable(log))) {
    // The student's code can write here as well, and std::regex goes one call deeper with each
    // character that is repeated.
    line.resize(std::min(line.size(), kLongestLine));
    if (line.rfind("SUMMARY:", 0) == 0) break;
    if (line.empty() || line.find_first_not_of('=') == std::string::npos) continue;
    if (line.find("can not provide additional info") != std::string::npos) continue;
    const std::string kept = is_frame(line) ? cleaned_frame(line) : "  " + cleaned_line(line);
    if (kept.find_first_not_of(' ') != std::string::npos) text += kept + "\n";
  }
  return text;
}

void set_up_sanitizers(const Build& build) {
  const std::string log = "log_path=" + (build.logs.value().path() / kLogName).string();
  // "2": the worker's own handlers of signals do not get in the way.
  ::setenv("ASAN_OPTIONS",
           (log + ":detect_leaks=0:handle_segv=2:handle_sigbus=2:handle_sigfpe=2:"
                  "handle_abort=2:handle_sigill=2:detect_stack_use_after_return=1")
               .c_str(),
           1);
  ::setenv("UBSAN_OPTIONS", (log + ":print_stacktrace=1").c_str(), 1);
}

std::string read_sanitizer_log(const Build& build) {
  std::string log;
  for (const fs::directory_entry& entry : fs::directory_iterator(build.logs.value().path())) {
    // The code could have put a link there.
    if (entry.path().stem() != kLogName || !entry.is_regular_file() || entry.is_symlink()) {
      continue;
    }
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    log += text.str();
  }
  return clean_sanitizer_log(log);
}

CaseReport with_sanitizer_finding(CaseReport judged, const std::string& log) {
  Finding finding;
  finding.rule = "sanitizer";
  finding.meaning =
      "no memory is used that is not one's own, and nothing is done that C++ leaves undefined";
  const std::string first_line = log.substr(0, log.find('\n'));
  finding.actual =
      first_line.substr(std::min(first_line.find_first_not_of(' '), first_line.size()));
  judged.verdict = Verdict::kCrashed;
  judged.findings = {{finding, {}}};
  return judged;
}

}  // namespace meshgrade
