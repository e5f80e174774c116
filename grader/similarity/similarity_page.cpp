#include "grader/similarity/similarity_page.h"

#include <algorithm>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Shared code</title>
<style>
:root { color-scheme: light dark; --ink: #1b2127; --quiet: #545d68; --ground: #fff;
  --line: #dde1e6; --shared: #fdeab0; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #e7eaed; --quiet: #a4adb7; --ground: #14181c; --line: #343c45;
    --shared: #5a4512; } }
body { margin: 0 auto; max-width: 80rem; padding: 1.5rem 1rem 4rem; color: var(--ink);
  background: var(--ground); font: 16px/1.5 system-ui, 'DejaVu Sans', sans-serif; }
table { border-collapse: collapse; }
th, td { padding: 0.2rem 0.8rem 0.2rem 0; text-align: left; border-bottom: 1px solid var(--line); }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
a { color: inherit; }
.quiet { color: var(--quiet); max-width: 44rem; }
.pair { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr)); }
pre { overflow: auto; max-height: 40rem; padding: 0.6rem; border: 1px solid var(--line);
  border-radius: 8px; font: 13px/1.45 ui-monospace, 'DejaVu Sans Mono', monospace; tab-size: 4; }
mark { background: var(--shared); color: inherit; }
section { break-inside: avoid; margin-top: 2.5rem; }
</style>
<h1>Shared code</h1>
<p class="quiet">The percentages say how much of the one's code is in the other's, wherever it
stands: names, comments, layout and the order of functions make no difference. The skeleton does
not count, and what many have counts less. Short exercises have few good solutions: read both
sources before you say anything.</p>
)";

std::string cell(int percent) {
  return "<td class=\"number\">" + std::to_string(percent) + " %</td>";
}

std::string groups_section(const std::vector<SimilarPair>& pairs) {
  std::string html = "<h2>Groups</h2>\n";
  const auto groups = groups_of(pairs, kGroupPercent);
  if (groups.empty()) {
    return html + "<p>No two have " + std::to_string(kGroupPercent) +
           " % or more in common.</p>\n";
  }
  html += "<p class=\"quiet\">Connected by pairs of " + std::to_string(kGroupPercent) +
          " % and more.</p>\n<ul>\n";
  for (const std::vector<std::string>& group : groups)
    html += "<li>" + html_text(join(group, ", ")) + "</li>\n";
  return html + "</ul>\n";
}

std::string pairs_section(const std::vector<SimilarPair>& pairs, std::size_t shown) {
  std::string html =
      "<h2>Pairs</h2>\n<table>\n<tr><th>first</th><th>of the first</th><th>second</th>"
      "<th>of the second</th></tr>\n";
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::string name = html_text(pairs[i].first);
    const std::string link =
        i < shown ? "<a href=\"#pair" + std::to_string(i + 1) + "\">" + name + "</a>" : name;
    html += "<tr><td>" + link + "</td>" + cell(pairs[i].of_first) + "<td>" +
            html_text(pairs[i].second) + "</td>" + cell(pairs[i].of_second) + "</tr>\n";
  }
  return html + "</table>\n";
}

/// Without spaces at the ends of lines: where the skeleton's lines were there is nothing else.
std::string trimmed(const std::string& html) {
  std::string kept;
  for (char c : html) {
    while (c == '\n' && !kept.empty() && (kept.back() == ' ' || kept.back() == '\t'))
      kept.pop_back();
    kept += c;
  }
  return kept;
}

std::string marked(const std::string& text, const std::vector<TextRange>& parts) {
  std::string html;
  std::size_t at = 0;
  for (const TextRange& part : parts) {
    html += html_text(text.substr(at, part.begin - at)) + "<mark>" +
            html_text(text.substr(part.begin, part.end - part.begin)) + "</mark>";
    at = part.end;
  }
  return trimmed(html + html_text(text.substr(at)));
}

std::string sources(const SharedCode& code, std::size_t of, std::size_t with) {
  const HandInText& text = code.texts()[of];
  const auto parts = code.shared_parts(of, with);
  std::string html = "<div>\n<h3>" + html_text(text.key) + "</h3>\n";
  for (std::size_t f = 0; f < text.files.size(); ++f) {
    html += "<h4>" + html_text(text.files[f].name) + "</h4>\n<pre>" +
            marked(text.files[f].text, parts[f]) + "</pre>\n";
  }
  return html + "</div>\n";
}

}  // namespace

std::string similarity_page(const SharedCode& code, const std::vector<SimilarPair>& pairs,
                            std::size_t shown) {
  std::string html = kHead + groups_section(pairs) + pairs_section(pairs, shown);
  for (std::size_t i = 0; i < std::min(shown, pairs.size()); ++i) {
    const SimilarPair& pair = pairs[i];
    html += "<section id=\"pair" + std::to_string(i + 1) + "\">\n<h2>" + html_text(pair.first) +
            " and " + html_text(pair.second) + "</h2>\n<div class=\"pair\">\n" +
            sources(code, pair.first_at, pair.second_at) +
            sources(code, pair.second_at, pair.first_at) + "</div>\n</section>\n";
  }
  return html + "</html>\n";
}

}  // namespace meshgrade
