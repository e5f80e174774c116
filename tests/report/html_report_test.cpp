// A report as a page: data that no text of it can break out of.

#include "grader/report/html_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

const std::string kPage =
    "<meta content=\"connect-src 'none'\"><script type=\"application/json\">"
    "{\"kind\":\"empty\"}</script>";

std::string data_of(const std::string& page) {
  const std::string begin = "application/json\">";
  const std::size_t from = page.find(begin) + begin.size();
  return page.substr(from, page.find("</script>", from) - from);
}

TEST(HtmlReport, NoTextEndsTheElementThatHoldsIt) {
  Report report;
  report.submission = "</script><script>alert(1)</script><!--";
  const std::string page = to_html(report, kPage);
  const std::string data = data_of(page);
  EXPECT_EQ(data.find('<'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(data)["report"]["submission"], report.submission);
}

TEST(HtmlReport, StepThatWentWrongComesWithItsMeshes) {
  CaseReport failed;
  failed.scene.step = "flip e0";
  failed.scene.edge = 0;
  failed.scene.yours.vertices = {{0, 1, {1.0, 2.0, NAN}}};
  failed.scene.yours.halfedges = {{0, kUnsetRef, 0, 0, 0, 1}};
  Report report;
  report.exercises.emplace_back().cases = {CaseReport{}, failed};
  const auto data = nlohmann::json::parse(data_of(to_html(report, kPage)));
  const auto& cases = data["report"]["exercises"][0]["cases"];
  EXPECT_FALSE(cases[0].contains("scene"));
  const auto& scene = cases[1]["scene"];
  EXPECT_EQ(scene["yours"]["h"], (std::vector<std::uint32_t>{0, kUnsetRef, 0, 0, 0, 1}));
  EXPECT_EQ(scene["yours"]["p"][1], 2.0);
  EXPECT_TRUE(scene["yours"]["p"][2].is_null());
  EXPECT_FALSE(scene["broken"].empty());
  EXPECT_EQ(scene["changes"].size(), 6U);
}

TEST(HtmlReport, OnlyAServedPageMayReachItsServer) {
  const nlohmann::ordered_json data{{"kind", "live"}};
  EXPECT_NE(fill_page(kPage, data, PageAccess::kNone).find("connect-src 'none'"),
            std::string::npos);
  EXPECT_NE(fill_page(kPage, data, PageAccess::kOwnServer).find("connect-src 'self'"),
            std::string::npos);
}

TEST(HtmlReport, AnotherPageIsNotFilled) {
  EXPECT_THROW(fill_page("<html></html>", {}, PageAccess::kNone), GraderError);
}

}  // namespace
}  // namespace meshgrade
