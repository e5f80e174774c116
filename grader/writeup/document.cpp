#include "grader/writeup/document.h"

#include "grader/base/text.h"

namespace meshgrade {
namespace {

constexpr const char* kRoom = "Your words here.";
constexpr const char* kWrongTitle = "Not right yet:";

/// Marks that Markdown would take for its own are escaped.
std::string markdown_text(const std::string& text) {
  std::string safe;
  for (const char c : printable(text)) {
    if (std::string("\\`*_{}[]<>#|~$&!").find(c) != std::string::npos) safe += '\\';
    safe += c;
  }
  return safe;
}

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1b2127; --quiet: #545d68; --ground: #fff;
  --line: #dde1e6; --wrong: #ad3500; --soft: #fdeee6; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #e7eaed; --quiet: #a4adb7; --ground: #14181c; --line: #343c45;
    --wrong: #ff9f70; --soft: #43241a; } }
body { margin: 0 auto; max-width: 62rem; padding: 1.5rem 1rem 4rem; color: var(--ink);
  background: var(--ground); font: 16px/1.55 system-ui, 'DejaVu Sans', sans-serif; }
h1 { line-height: 1.2; } h2 { margin-top: 2.5rem; }
.asks { color: var(--quiet); }
.words { border: 1px dashed var(--line); border-radius: 8px; padding: 1rem; min-height: 4rem; }
.pictures { display: grid; gap: 1rem;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 26rem), 1fr)); }
figure { margin: 0; break-inside: avoid; }
img { display: block; max-width: 100%; height: auto; border: 1px solid var(--line);
  border-radius: 8px; }
figcaption { margin-top: 0.3rem; }
.wrong { background: var(--soft); border-left: 3px solid var(--wrong); padding: 0.4rem 0.7rem;
  margin: 0.4rem 0 0; white-space: pre-line; overflow-wrap: anywhere; }
)";

std::string figure_html(const WriteupPicture& picture) {
  std::string text = "<figure><img src=\"" + html_text(picture.file) + "\" alt=\"" +
                     html_text(picture.caption) + "\">\n<figcaption>" +
                     html_text(picture.caption);
  if (!picture.told.empty()) {
    text += "\n<p class=\"wrong\"><strong>" + std::string(kWrongTitle) + "</strong>\n";
    for (const std::string& line : split_lines(picture.told))
      text += html_text(line) + "\n";
    text += "</p>";
  }
  return text + "</figcaption></figure>\n";
}

}  // namespace

std::string to_markdown(const Writeup& writeup) {
  std::string text = "# " + markdown_text(writeup.title) + "\n\nPictures by the functions of " +
                     markdown_text(writeup.submission) + ".\n";
  for (const WriteupPart& part : writeup.parts) {
    text += "\n## " + markdown_text(part.heading) + "\n";
    if (!part.asks.empty()) text += "\n> " + markdown_text(part.asks) + "\n";
    text += "\n" + std::string(kRoom) + "\n";
    for (const WriteupPicture& picture : part.pictures) {
      text += "\n![" + markdown_text(picture.caption) + "](" + picture.file + ")\n\n*" +
              markdown_text(picture.caption) + "*\n";
      if (picture.told.empty()) continue;
      text += "\n> **" + std::string(kWrongTitle) + "**\n";
      for (const std::string& line : split_lines(picture.told))
        text += "> " + markdown_text(line) + "  \n";
    }
  }
  return text;
}

std::string to_html(const Writeup& writeup) {
  std::string text =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
      html_text(writeup.title) + "</title>\n<style>" + kStyle +
      "</style>\n</head>\n<body>\n<h1>" + html_text(writeup.title) +
      "</h1>\n<p class=\"asks\">Pictures by the functions of " + html_text(writeup.submission) +
      ".</p>\n";
  for (const WriteupPart& part : writeup.parts) {
    text += "\n<h2>" + html_text(part.heading) + "</h2>\n";
    if (!part.asks.empty()) text += "<p class=\"asks\">" + html_text(part.asks) + "</p>\n";
    text += "<div class=\"words\">" + std::string(kRoom) + "</div>\n";
    if (part.pictures.empty()) continue;
    text += "<div class=\"pictures\">\n";
    for (const WriteupPicture& picture : part.pictures)
      text += figure_html(picture);
    text += "</div>\n";
  }
  return text + "</body>\n</html>\n";
}

}  // namespace meshgrade
