#include "grader/base/pattern.h"

#include <regex>

namespace meshgrade {
namespace {

Pattern::Groups texts_of(const std::smatch& found) {
  Pattern::Groups groups;
  for (const auto& group : found)
    groups.push_back(group.str());
  return groups;
}

}  // namespace

struct Pattern::Form {
  std::regex regex;
};

Pattern::Pattern(const std::string& form)
    : form_(std::make_shared<const Form>(Form{std::regex(form)})) {}

bool Pattern::matches(const std::string& text) const {
  return std::regex_match(text, form_->regex);
}

bool Pattern::matches(const std::string& text, Groups& groups) const {
  std::smatch found;
  if (!std::regex_match(text, found, form_->regex)) return false;
  groups = texts_of(found);
  return true;
}

bool Pattern::is_in(const std::string& text) const {
  return std::regex_search(text, form_->regex);
}

bool Pattern::is_in(const std::string& text, Groups& groups) const {
  std::smatch found;
  if (!std::regex_search(text, found, form_->regex)) return false;
  groups = texts_of(found);
  return true;
}

std::vector<Pattern::Place> Pattern::places_in(const std::string& text) const {
  std::vector<Place> places;
  const std::sregex_iterator end;
  for (std::sregex_iterator it(text.begin(), text.end(), form_->regex); it != end; ++it) {
    places.push_back(
        {static_cast<std::size_t>(it->position()), static_cast<std::size_t>(it->length())});
  }
  return places;
}

std::string Pattern::replaced(const std::string& text, const std::string& by) const {
  return std::regex_replace(text, form_->regex, by);
}

}  // namespace meshgrade
