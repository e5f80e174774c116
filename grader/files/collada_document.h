#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace meshgrade {

/// The XML of a COLLADA file, with the line of each element for messages. Every fault is a
/// UserError "<file>:<line>: ...".
class ColladaDocument {
 public:
  ColladaDocument(const std::filesystem::path& file, std::string_view bytes);

  const std::filesystem::path& file() const { return file_; }
  pugi::xml_node root() const { return root_; }
  std::string line_of(const pugi::xml_node& node) const;
  [[noreturn]] void refuse(const pugi::xml_node& node, const std::string& what) const;

  /// The element of one of these kinds that an attribute like url="#id" names. Elements of
  /// different kinds may have the same id. Of sources, those of the same mesh come first, since
  /// some exporters give the same ids in every mesh.
  pugi::xml_node referred(const pugi::xml_node& node, const char* attribute,
                          std::initializer_list<std::string_view> kinds) const;

  /// The numbers in the text of an element.
  std::vector<double> reals(const pugi::xml_node& node) const;
  std::vector<double> reals(const pugi::xml_node& node, std::size_t count) const;
  std::vector<std::uint32_t> indices(const pugi::xml_node& node) const;
  /// A whole number from 0.
  std::size_t count_attribute(const pugi::xml_node& node, const char* name,
                              std::size_t otherwise) const;

 private:
  std::string line_at(std::ptrdiff_t offset) const;
  void collect_ids();

  std::filesystem::path file_;
  std::vector<std::size_t> line_ends_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::unordered_multimap<std::string, pugi::xml_node> by_id_;
};

/// The whole text of an element. Comments may part it into pieces.
std::string text_of(const pugi::xml_node& node);

}  // namespace meshgrade
