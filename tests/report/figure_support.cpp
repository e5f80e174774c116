#include "tests/report/figure_support.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "grader/report/label_boxes.h"
#include "grader/report/svg_figure.h"
#include "tests/support/right_answers.h"

namespace meshgrade {
namespace {

/// What a text covers, by a measure of its own: letters of the code type are 0.6 wide.
Box letters_of(pugi::xml_node text) {
  const double size = text.attribute("font-size").as_double();
  const double width = 0.6 * size * static_cast<double>(std::string(text.text().get()).size());
  const std::string anchor = text.attribute("text-anchor").as_string("start");
  const double x = text.attribute("x").as_double() - (anchor == "middle" ? 0.5 * width
                                                      : anchor == "end"  ? width
                                                                         : 0.0);
  const double y = text.attribute("y").as_double();
  return {x, y - 0.75 * size, x + width, y + 0.15 * size};
}

}  // namespace

CaseReport judged(const Case& c, const Outcome& outcome) {
  const ExerciseRubric& rubric = *standard_rubric().find(c.exercise);
  const ExerciseJudge exercise = find_exercise_judge(rubric);
  Conventions conventions = exercise.conventions;
  const CaseJudgement judgement = judge_case(exercise, {c, outcome, rubric, 1e-5}, conventions);
  CaseReport report;
  report.id = c.id();
  report.title = c.title;
  report.verdict = judgement.verdict;
  for (const Finding& finding : judgement.findings)
    report.findings.push_back({finding, {}});
  return report;
}

CaseReport judged(const Case& c, const std::vector<std::string>& steps) {
  Outcome outcome;
  outcome.steps = steps;
  return judged(c, outcome);
}

Finding& finding_of(CaseReport& report) {
  return report.findings.at(0).finding;
}

Picture::Picture(const CaseReport& report) : text(to_svg(report, "p")) {
  const pugi::xml_parse_result result =
      document.load_buffer(text.data(), text.size(), pugi::parse_full);
  EXPECT_TRUE(result) << result.description() << "\n" << text;
  root = document.child("svg");
}

std::vector<pugi::xml_node> Picture::of_class(const std::string& word,
                                              pugi::xml_node under) const {
  std::vector<pugi::xml_node> nodes;
  for (const pugi::xpath_node& node : under.select_nodes(
           (".//*[contains(concat(' ', @class, ' '), ' " + word + " ')]").c_str())) {
    nodes.push_back(node.node());
  }
  return nodes;
}

pugi::xml_node Picture::panel(const std::string& name) const {
  const auto found = of_class(name, root);
  return found.empty() ? pugi::xml_node() : found[0];
}

std::string all_text(pugi::xml_node node) {
  std::string text;
  for (const pugi::xpath_node& found : node.select_nodes(".//text"))
    text += std::string(found.node().text().get()) + "\n";
  return text;
}

std::string overlapping_labels(pugi::xml_node panel) {
  std::vector<pugi::xml_node> texts;
  for (const pugi::xpath_node& found : panel.select_nodes(".//text"))
    texts.push_back(found.node());
  std::string faults;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!overlap(letters_of(texts[i]), letters_of(texts[j]))) continue;
      faults += std::string(texts[i].text().get()) + " at " +
                texts[i].attribute("x").as_string() + " " +
                texts[i].attribute("y").as_string() + " on " + texts[j].text().get() + " at " +
                texts[j].attribute("x").as_string() + " " +
                texts[j].attribute("y").as_string() + "\n";
    }
  }
  return faults;
}

}  // namespace meshgrade
