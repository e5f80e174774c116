#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace meshgrade {

/// A regular expression in the form of ECMAScript: that of the standard library behind
/// functions that are compiled once, since <regex> costs each file that uses it some seconds.
///
/// It goes one call deeper with each repetition: a form that may repeat without bound must not
/// be given a text of somebody else's of any length.
class Pattern {
 public:
  /// Texts of the whole and of the groups; empty for a group that has no part in it.
  using Groups = std::vector<std::string>;

  struct Place {
    std::size_t begin = 0;
    std::size_t size = 0;
  };

  /// @throws std::regex_error if the form is none
  explicit Pattern(const std::string& form);

  /// Whether all of the text has this form.
  bool matches(const std::string& text) const;
  bool matches(const std::string& text, Groups& groups) const;

  /// Whether a part of the text has it; the groups are of the first.
  bool is_in(const std::string& text) const;
  bool is_in(const std::string& text, Groups& groups) const;

  /// All parts that have it, in order and apart from each other.
  std::vector<Place> places_in(const std::string& text) const;

  /// The text with `by` in place of each of them; "$1" in it is the first group.
  std::string replaced(const std::string& text, const std::string& by) const;

 private:
  struct Form;
  std::shared_ptr<const Form> form_;
};

}  // namespace meshgrade
