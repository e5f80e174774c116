#include "grader/view/browser.h"

#include <unistd.h>

#include <cstdlib>

#include "grader/base/process.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/sandbox/system_paths.h"

namespace meshgrade {
namespace {

constexpr auto kPatience = std::chrono::seconds(90);
constexpr const char* kPngSignature = "\x89PNG\r\n\x1a\n";

/// The variables that lead a browser to folders of its user's own lead it into `home`.
std::vector<std::string> environment_with(const std::filesystem::path& home) {
  const char* path = std::getenv("PATH");
  return {std::string("PATH=") + (path != nullptr ? path : "/usr/bin:/bin"),
          "LC_ALL=C.UTF-8",
          "HOME=" + home.string(),
          "TMPDIR=" + home.string(),
          "XDG_CONFIG_HOME=" + home.string(),
          "XDG_CACHE_HOME=" + home.string(),
          "XDG_RUNTIME_DIR=" + home.string()};
}

std::vector<std::string> arguments_for(const std::filesystem::path& browser,
                                       const std::filesystem::path& folder, PictureSize size,
                                       bool dark) {
  std::vector<std::string> arguments{
      browser.string(), "--headless", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--disable-quic",
      "--disable-crash-reporter", "--disable-breakpad", "--hide-scrollbars",
      "--force-device-scale-factor=1", "--force-color-profile=srgb",
      // Without a graphics card too, and with the same picture everywhere.
      "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
      std::string("--blink-settings=preferredColorScheme=") + (dark ? "0" : "1"),
      "--user-data-dir=" + (folder / "profile").string(),
      "--window-size=" + std::to_string(size.width) + "," + std::to_string(size.height),
      "--screenshot=" + (folder / "picture.png").string()};
  // Chromium refuses to work for root with a sandbox. The page is our own, and asks for
  // nothing.
  if (::geteuid() == 0) arguments.emplace_back("--no-sandbox");
  arguments.push_back("file://" + (folder / "page.html").string());
  return arguments;
}

/// The last words of what it printed.
std::string last_words(const std::string& output) {
  const std::vector<std::string> lines = split_lines(output);
  return lines.empty() ? "it printed nothing" : "its last line: " + printable(lines.back());
}

}  // namespace

std::filesystem::path find_browser() {
  for (const char* name :
       {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"}) {
    std::filesystem::path found = find_program(name);
    if (!found.empty()) return found;
  }
  return {};
}

Photograph photograph(const std::filesystem::path& browser, const std::string& page,
                      PictureSize size, bool dark) {
  const ScratchFolder scratch;
  const std::filesystem::path& folder = scratch.path();
  write_file_safely(folder / "page.html", page);
  Command command;
  command.arguments = arguments_for(browser, folder, size, dark);
  command.environment = environment_with(folder);
  command.time_limit = kPatience;
  const ProcessResult result = run_process(command);
  if (result.timed_out) {
    return {"", browser.string() + " did not come to its end; " + last_words(result.output)};
  }
  const std::filesystem::path picture = folder / "picture.png";
  std::error_code error;
  if (!result.ok() || !std::filesystem::is_regular_file(picture, error)) {
    return {"", browser.string() + " took no picture; " + last_words(result.output)};
  }
  std::string png = read_whole_file(picture);
  if (png.rfind(kPngSignature, 0) != 0) return {"", browser.string() + " wrote no PNG picture"};
  return {std::move(png), ""};
}

}  // namespace meshgrade
