#include "grader/view/picture_file.h"

#include "grader/base/safe_file.h"
#include "grader/view/browser.h"

namespace meshgrade {
namespace {

WrittenPicture write_svg(const std::filesystem::path& file, const Drawing& drawing,
                         const std::string& why) {
  write_file_safely(file, drawing.svg());
  return {file, "drawn by the grader itself, as SVG" + why};
}

}  // namespace

WrittenPicture write_picture(const std::filesystem::path& out, const Drawing& drawing,
                             const PictureRequest& request) {
  if (out.extension() == ".svg") return write_svg(out, drawing, "");
  const std::filesystem::path instead = std::filesystem::path(out).replace_extension(".svg");
  const std::filesystem::path browser = find_browser();
  if (browser.empty()) {
    return write_svg(
        instead, drawing,
        ", because no browser is on the PATH (chromium, chromium-browser, google-chrome)");
  }
  const Photograph taken = photograph(browser, drawing.page(), request.size, request.dark);
  if (taken.png.empty()) return write_svg(instead, drawing, ", because " + taken.why);
  write_file_safely(out, taken.png);
  return {out, "taken by " + browser.string()};
}

}  // namespace meshgrade
