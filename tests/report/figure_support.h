#pragma once

// For tests of pictures: a case that is judged, and its picture taken apart.

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "grader/report/report.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {

/// What a submission gets that leaves this behind.
CaseReport judged(const Case& c, const Outcome& outcome);

/// The same for one that ends as it should, with these steps.
CaseReport judged(const Case& c, const std::vector<std::string>& steps);

/// The first finding, to look at or to change.
Finding& finding_of(CaseReport& report);

/// The picture of a report, as XML. Adds a failure if it is none.
struct Picture {
  explicit Picture(const CaseReport& report);

  /// All elements under a node whose class attribute has this word.
  std::vector<pugi::xml_node> of_class(const std::string& word, pugi::xml_node under) const;

  pugi::xml_node panel(const std::string& name) const;

  std::string text;
  pugi::xml_document document;
  pugi::xml_node root;
};

/// A line for each text under a node.
std::string all_text(pugi::xml_node node);

/// A line for each two labels of a panel that lie on each other.
std::string overlapping_labels(pugi::xml_node panel);

}  // namespace meshgrade
