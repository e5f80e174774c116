#include "grader/report/html_report.h"

#include "grader/base/errors.h"
#include "grader/report/mesh_json.h"
#include "grader/report/report_value.h"
#include "grader/report/svg_figure.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

/// With "<" written as an escape: no text can end the element that the data stands in.
std::string script_text(const Json& data) {
  const std::string json = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

void replace_mark(std::string& page, const std::string& mark, const std::string& text) {
  const std::size_t place = page.find(mark);
  if (place == std::string::npos) {
    throw GraderError("the viewer's page has no \"" + mark + "\": was it built?");
  }
  page.replace(place, mark.size(), text);
}

}  // namespace

std::string fill_page(std::string page, const Json& data, PageAccess access) {
  if (access == PageAccess::kOwnServer) {
    replace_mark(page, "connect-src 'none'", "connect-src 'self'");
  }
  replace_mark(page, "{\"kind\":\"empty\"}", script_text(data));
  return page;
}

std::string to_html(const Report& report, const std::string& page) {
  Json data{{"kind", "report"}, {"report", to_json_value(report)}};
  Json& exercises = data["report"]["exercises"];
  for (std::size_t i = 0; i < report.exercises.size(); ++i) {
    const std::vector<CaseReport>& cases = report.exercises[i].cases;
    for (std::size_t c = 0; c < cases.size(); ++c) {
      Json& value = exercises[i]["cases"][c];
      const std::string picture =
          to_svg(cases[c], "figure-" + std::to_string(i) + "-" + std::to_string(c));
      if (!picture.empty()) value["picture"] = picture;
      if (!cases[c].scene.empty()) value["scene"] = to_json_value(cases[c].scene);
    }
  }
  return fill_page(page, data, PageAccess::kNone);
}

std::string class_to_html(const Json& results, const std::map<std::string, std::string>& links,
                          const Json& similar, const std::string& page) {
  const Json data{
      {"kind", "class"}, {"class", results}, {"links", links}, {"similar", similar}};
  return fill_page(page, data, PageAccess::kNone);
}

}  // namespace meshgrade
