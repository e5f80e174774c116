#include "grader/files/collada_document.h"

#include <algorithm>

#include "grader/files/file_bytes.h"
#include "grader/files/text_scanner.h"
#include "grader/files/utf8_text.h"

namespace meshgrade {
namespace {

bool is_one_of(std::string_view kind, std::initializer_list<std::string_view> kinds) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Hands each word of the text to `parse`, which says whether it is a number that fits.
template <typename Number, typename Parse>
std::vector<Number> numbers(const ColladaDocument& document, const pugi::xml_node& node,
                            Parse parse) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::string whole = text_of(node);
  std::string_view text = whole;
  std::vector<Number> values;
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (text.empty()) return values;
    const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
    Number value{};
    if (!parse(word, value)) {
      document.refuse(node, in_quotes(word) + " is no number that fits here");
    }
    values.push_back(value);
    text.remove_prefix(word.size());
  }
}

}  // namespace

std::string text_of(const pugi::xml_node& node) {
  std::string text;
  for (const auto& child : node.children()) {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
      text += child.value();
    }
  }
  return text;
}

ColladaDocument::ColladaDocument(const std::filesystem::path& file, std::string_view bytes)
    : file_(file) {
  const Utf8Text utf8(bytes);
  const std::string_view text = utf8.view();
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '\n') line_ends_.push_back(k);
  }
  const bool is_utf8 = text.data() != bytes.data();  // if a mark has told so
  const pugi::xml_parse_result parsed =
      document_.load_buffer(text.data(), text.size(), pugi::parse_default,
                            is_utf8 ? pugi::encoding_utf8 : pugi::encoding_auto);
  if (!parsed) {
    refuse_file(file_, line_at(parsed.offset),
                std::string("is not well-formed XML: ") + parsed.description());
  }
  root_ = document_.child("COLLADA");
  if (!root_) refuse_file(file_, "1", "has no element COLLADA; is it another format?");
  if (const std::string version = root_.attribute("version").value();
      version.starts_with("1.3")) {
    refuse(root_, "is COLLADA " + in_quotes(version) +
                      ", which is not read; export as COLLADA 1.4 or 1.5");
  }
  collect_ids();
}

std::string ColladaDocument::line_at(std::ptrdiff_t offset) const {
  const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
  const auto end = std::lower_bound(line_ends_.begin(), line_ends_.end(), at);
  return std::to_string(1 + (end - line_ends_.begin()));
}

std::string ColladaDocument::line_of(const pugi::xml_node& node) const {
  return line_at(node.offset_debug());
}

void ColladaDocument::refuse(const pugi::xml_node& node, const std::string& what) const {
  refuse_file(file_, line_of(node), what);
}

void ColladaDocument::collect_ids() {
  struct Walker : pugi::xml_tree_walker {
    std::unordered_multimap<std::string, pugi::xml_node> by_id;
    bool for_each(pugi::xml_node& node) override {
      if (const auto id = node.attribute("id")) by_id.emplace(id.value(), node);
      return true;
    }
  } walker;
  root_.traverse(walker);
  by_id_ = std::move(walker.by_id);
}

pugi::xml_node ColladaDocument::referred(const pugi::xml_node& node, const char* attribute,
                                         std::initializer_list<std::string_view> kinds) const {
  const std::string url = node.attribute(attribute).value();
  const std::string id = url.starts_with('#') ? url.substr(1) : "";
  for (auto near = node.parent(); near && is_one_of("source", kinds); near = near.parent()) {
    for (const auto& child : near.children()) {
      if (is_one_of(child.name(), kinds) && id == child.attribute("id").value()) return child;
    }
  }
  const auto [begin, end] = by_id_.equal_range(id);
  pugi::xml_node found;
  for (auto entry = begin; entry != end; ++entry) {
    // The order of equal keys is nobody's promise: the first of the file counts.
    if (!is_one_of(entry->second.name(), kinds)) continue;
    if (!found || entry->second.offset_debug() < found.offset_debug()) found = entry->second;
  }
  if (found) return found;
  if (begin == end || id.empty()) {
    refuse(node, in_quotes(url) + " names no element of this file; only '#id' is followed");
  }
  refuse(node, in_quotes(url) + " names an element " + in_quotes(begin->second.name()) +
                   " where " + std::string(*kinds.begin()) + " should be");
}

std::vector<double> ColladaDocument::reals(const pugi::xml_node& node) const {
  return numbers<double>(*this, node, parse_number);
}

std::vector<double> ColladaDocument::reals(const pugi::xml_node& node,
                                           std::size_t count) const {
  std::vector<double> values = reals(node);
  if (values.size() != count) {
    refuse(node, std::string(node.name()) + " needs " + std::to_string(count) + " numbers");
  }
  return values;
}

std::vector<std::uint32_t> ColladaDocument::indices(const pugi::xml_node& node) const {
  return numbers<std::uint32_t>(*this, node, [](std::string_view word, std::uint32_t& value) {
    std::int64_t number = 0;
    if (!parse_integer(word, number) || number < 0 || number > UINT32_MAX) return false;
    value = static_cast<std::uint32_t>(number);
    return true;
  });
}

std::size_t ColladaDocument::count_attribute(const pugi::xml_node& node, const char* name,
                                             std::size_t otherwise) const {
  const auto attribute = node.attribute(name);
  if (!attribute) return otherwise;
  std::int64_t number = 0;
  if (!parse_integer(attribute.value(), number) || number < 0 || number > INT32_MAX) {
    refuse(node, std::string(name) + " is " + in_quotes(attribute.value()) +
                     "; it must be a whole number from 0");
  }
  return static_cast<std::size_t>(number);
}

}  // namespace meshgrade
