#include "grader/files/collada_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <pugixml.hpp>
#include <sstream>
#include <unordered_map>

#include "grader/files/file_bytes.h"
#include "grader/files/scene.h"
#include "grader/files/text_scanner.h"

namespace meshgrade {
namespace {

using Path = std::filesystem::path;

constexpr int kDeepestNodes = 64;
constexpr std::size_t kMostNodes = 100'000;

class ColladaReader {
 public:
  ColladaReader(const Path& file, const std::string& bytes) : file_(file) {
    for (std::size_t k = 0; k < bytes.size(); ++k) {
      if (bytes[k] == '\n') line_ends_.push_back(k);
    }
    const pugi::xml_parse_result parsed = document_.load_buffer(bytes.data(), bytes.size());
    if (!parsed) {
      refuse_file(file_, line_of(parsed.offset),
                  std::string("is not well-formed XML: ") + parsed.description());
    }
    root_ = document_.child("COLLADA");
    if (!root_) refuse_file(file_, "1", "has no element COLLADA; is it another format?");
    collect_ids();
  }

  PolygonMesh read() {
    const Transform up = up_axis();
    if (const auto scene = root_.child("scene").child("instance_visual_scene")) {
      for (const auto& node : referred(scene, "url").children("node"))
        add_node(node, up, 0);
    } else {
      for (const auto& geometry : root_.child("library_geometries").children("geometry")) {
        append_part(whole_, geometry_mesh(geometry), up, file_, line_of(geometry));
      }
    }
    return std::move(whole_);
  }

 private:
  /// One `input` of a primitive or of `vertices`.
  struct Input {
    pugi::xml_node source;
    std::size_t offset = 0;
  };

  std::string line_of(std::ptrdiff_t offset) const {
    const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
    const auto end = std::lower_bound(line_ends_.begin(), line_ends_.end(), at);
    return std::to_string(1 + (end - line_ends_.begin()));
  }
  std::string line_of(const pugi::xml_node& node) const { return line_of(node.offset_debug()); }

  [[noreturn]] void refuse(const pugi::xml_node& node, const std::string& what) const {
    refuse_file(file_, line_of(node), what);
  }

  void collect_ids() {
    struct Walker : pugi::xml_tree_walker {
      std::unordered_map<std::string, pugi::xml_node> by_id;
      bool for_each(pugi::xml_node& node) override {
        if (const auto id = node.attribute("id")) by_id.emplace(id.value(), node);
        return true;
      }
    } walker;
    root_.traverse(walker);
    by_id_ = std::move(walker.by_id);
  }

  /// The element that an attribute like url="#id" names.
  pugi::xml_node referred(const pugi::xml_node& node, const char* attribute) const {
    const std::string url = node.attribute(attribute).value();
    const auto found = by_id_.find(url.starts_with('#') ? url.substr(1) : "");
    if (found == by_id_.end()) {
      refuse(node, in_quotes(url) + " names no element of this file; only '#id' is followed");
    }
    return found->second;
  }

  template <typename Number, typename Parse>
  std::vector<Number> numbers(const pugi::xml_node& node, Parse parse) const {
    constexpr std::string_view kBlanks = " \t\r\n";
    std::string_view text = node.child_value();
    std::vector<Number> values;
    for (;;) {
      text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
      if (text.empty()) return values;
      const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
      Number value{};
      if (!parse(word, value)) refuse(node, in_quotes(word) + " is no number that fits here");
      values.push_back(value);
      text.remove_prefix(word.size());
    }
  }
  std::vector<double> reals(const pugi::xml_node& node) const {
    return numbers<double>(node, parse_number);
  }
  std::vector<std::uint32_t> indices(const pugi::xml_node& node) const {
    return numbers<std::uint32_t>(node, [](std::string_view word, std::uint32_t& value) {
      std::int64_t number = 0;
      if (!parse_integer(word, number) || number < 0 || number > UINT32_MAX) return false;
      value = static_cast<std::uint32_t>(number);
      return true;
    });
  }

  std::size_t count_attribute(const pugi::xml_node& node, const char* name,
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

  Input find_input(const pugi::xml_node& node, std::string_view semantic) const {
    for (const auto& input : node.children("input")) {
      if (input.attribute("semantic").value() == semantic) {
        return {referred(input, "source"), count_attribute(input, "offset", 0)};
      }
    }
    refuse(node, "has no input " + std::string(semantic));
  }

  std::vector<Point3> source_points(const pugi::xml_node& source) const {
    const auto accessor = source.child("technique_common").child("accessor");
    const std::vector<double> floats = reals(source.child("float_array"));
    const std::size_t stride = count_attribute(accessor, "stride", 3);
    const std::size_t offset = count_attribute(accessor, "offset", 0);
    if (stride < 3) refuse(source, "positions need a stride of 3 or more");
    std::vector<Point3> points;
    for (std::size_t k = offset; k + 2 < floats.size(); k += stride) {
      points.push_back({floats[k], floats[k + 1], floats[k + 2]});
    }
    if (const std::size_t promised = count_attribute(accessor, "count", points.size());
        promised > points.size()) {
      refuse(source, "promises " + std::to_string(promised) + " positions and holds " +
                         std::to_string(points.size()));
    }
    return points;
  }

  /// The corners of a primitive's polygons, one list per polygon, with all their inputs.
  std::vector<std::vector<std::uint32_t>> corner_lists(const pugi::xml_node& primitive,
                                                       std::size_t n_inputs) const {
    const std::string_view kind = primitive.name();
    std::vector<std::vector<std::uint32_t>> lists;
    if (kind == "polygons") {
      if (primitive.child("ph")) refuse(primitive, "polygons with holes are not read");
      for (const auto& p : primitive.children("p"))
        lists.push_back(indices(p));
      return lists;
    }
    const std::vector<std::uint32_t> flat = indices(primitive.child("p"));
    std::vector<std::uint32_t> sizes;
    if (kind == "polylist") {
      sizes = indices(primitive.child("vcount"));
    } else {
      sizes.assign(flat.size() / (3 * n_inputs), 3);
    }
    std::size_t at = 0;
    for (const std::uint32_t size : sizes) {
      if (size > (flat.size() - at) / n_inputs) break;
      const auto begin = flat.begin() + static_cast<std::ptrdiff_t>(at);
      at += size * n_inputs;
      lists.emplace_back(begin, flat.begin() + static_cast<std::ptrdiff_t>(at));
    }
    if (at != flat.size() || lists.size() != sizes.size()) {
      refuse(primitive, "its list p does not fit its " + std::to_string(sizes.size()) +
                            " polygons; the file may be cut off");
    }
    return lists;
  }

  void add_polygons(const pugi::xml_node& primitive, PolygonMesh& mesh,
                    pugi::xml_node& positions) const {
    const Input vertices = find_input(primitive, "VERTEX");
    const Input source = find_input(vertices.source, "POSITION");
    if (positions && positions != source.source) {
      refuse(primitive, "one geometry uses two lists of positions, which is not read");
    }
    if (!positions) {
      positions = source.source;
      mesh.positions = source_points(positions);
    }
    std::size_t n_inputs = 1;
    for (const auto& input : primitive.children("input")) {
      n_inputs = std::max(n_inputs, count_attribute(input, "offset", 0) + 1);
    }
    const std::string place = line_of(primitive);
    for (const auto& list : corner_lists(primitive, n_inputs)) {
      std::vector<std::uint32_t> polygon;
      for (std::size_t k = vertices.offset; k < list.size(); k += n_inputs) {
        polygon.push_back(list[k]);
      }
      check_polygon(file_, place, mesh.polygons.size(), polygon, mesh.positions.size(), 0);
      mesh.polygons.push_back(std::move(polygon));
    }
  }

  PolygonMesh geometry_mesh(const pugi::xml_node& geometry) const {
    PolygonMesh mesh;
    pugi::xml_node positions;
    for (const auto& child : geometry.child("mesh").children()) {
      const std::string_view kind = child.name();
      if (kind == "triangles" || kind == "polylist" || kind == "polygons") {
        add_polygons(child, mesh, positions);
      } else if (kind == "tristrips" || kind == "trifans") {
        refuse(child, std::string(kind) + " are not read; export triangles");
      }
    }
    return mesh;
  }

  std::vector<double> reals_of(const pugi::xml_node& node, std::size_t count) const {
    std::vector<double> values = reals(node);
    if (values.size() != count) {
      refuse(node, std::string(node.name()) + " needs " + std::to_string(count) + " numbers");
    }
    return values;
  }

  Transform one_transform(const pugi::xml_node& node) const {
    const std::string_view kind = node.name();
    if (kind == "translate" || kind == "scale") {
      const auto v = reals_of(node, 3);
      const Point3 by = {v[0], v[1], v[2]};
      return kind == "scale" ? scaling(by) : translation(by);
    }
    if (kind == "rotate") {
      const auto v = reals_of(node, 4);
      if (v[0] == 0 && v[1] == 0 && v[2] == 0) refuse(node, "rotate has no axis");
      return rotation({v[0], v[1], v[2]}, v[3] * std::numbers::pi / 180);
    }
    Transform transform;
    if (kind == "matrix") {
      const auto v = reals_of(node, 16);
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 4; ++c)
          transform.rows[r][c] = v[r * 4 + c];
      }
    } else if (kind == "lookat" || kind == "skew") {
      refuse(node, std::string(kind) + " is not read; export with a matrix");
    }
    return transform;
  }

  void add_node(const pugi::xml_node& node, const Transform& parent, int depth) {
    if (depth > kDeepestNodes || ++n_nodes_ > kMostNodes) {
      refuse(node, "the nodes are nested too deeply, or in a circle");
    }
    Transform transform = parent;
    for (const auto& child : node.children())
      transform = transform * one_transform(child);
    for (const auto& child : node.children()) {
      const std::string_view kind = child.name();
      if (kind == "node") {
        add_node(child, transform, depth + 1);
      } else if (kind == "instance_node") {
        add_node(referred(child, "url"), transform, depth + 1);
      } else if (kind == "instance_geometry") {
        append_part(whole_, geometry_mesh(referred(child, "url")), transform, file_,
                    line_of(child));
      } else if (kind == "instance_controller") {
        refuse(child, "skins and morphs are not read; export the plain geometry");
      }
    }
  }

  Transform up_axis() const {
    const std::string_view axis = root_.child("asset").child("up_axis").child_value();
    Transform turn;
    if (axis == "Z_UP") turn.rows = {{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}}};
    if (axis == "X_UP") turn.rows = {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}}};
    return turn;
  }

  const Path& file_;
  std::vector<std::size_t> line_ends_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::unordered_map<std::string, pugi::xml_node> by_id_;
  PolygonMesh whole_;
  std::size_t n_nodes_ = 0;
};

template <typename Number>
void append_number(std::string& text, Number number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  if (!text.empty()) text += ' ';
  text.append(digits.data(), end.ptr);
}

void add_input(pugi::xml_node parent, const char* semantic, const char* source) {
  auto input = parent.append_child("input");
  input.append_attribute("semantic") = semantic;
  input.append_attribute("source") = source;
}

void add_positions(pugi::xml_node collada_mesh, const PolygonMesh& mesh) {
  std::string text;
  for (const Point3& point : mesh.positions) {
    for (const double coordinate : point)
      append_number(text, coordinate);
  }
  auto source = collada_mesh.append_child("source");
  source.append_attribute("id") = "positions";
  auto array = source.append_child("float_array");
  array.append_attribute("id") = "positions-array";
  array.append_attribute("count") = static_cast<unsigned long long>(3 * mesh.positions.size());
  array.text() = text.c_str();
  auto accessor = source.append_child("technique_common").append_child("accessor");
  accessor.append_attribute("source") = "#positions-array";
  accessor.append_attribute("count") = static_cast<unsigned long long>(mesh.positions.size());
  accessor.append_attribute("stride") = 3;
  for (const char* axis : {"X", "Y", "Z"}) {
    auto param = accessor.append_child("param");
    param.append_attribute("name") = axis;
    param.append_attribute("type") = "float";
  }
  auto vertices = collada_mesh.append_child("vertices");
  vertices.append_attribute("id") = "vertices";
  add_input(vertices, "POSITION", "#positions");
}

void add_polylist(pugi::xml_node collada_mesh, const PolygonMesh& mesh) {
  std::string sizes;
  std::string corners;
  for (const auto& polygon : mesh.polygons) {
    append_number(sizes, polygon.size());
    for (const std::uint32_t v : polygon)
      append_number(corners, v);
  }
  auto polylist = collada_mesh.append_child("polylist");
  polylist.append_attribute("count") = static_cast<unsigned long long>(mesh.polygons.size());
  add_input(polylist, "VERTEX", "#vertices");
  polylist.child("input").append_attribute("offset") = 0;
  polylist.append_child("vcount").text() = sizes.c_str();
  polylist.append_child("p").text() = corners.c_str();
}

}  // namespace

PolygonMesh parse_collada(const std::filesystem::path& file, const std::string& bytes) {
  return ColladaReader(file, bytes).read();
}

std::string format_collada(const PolygonMesh& mesh) {
  pugi::xml_document document;
  auto root = document.append_child("COLLADA");
  root.append_attribute("xmlns") = "http://www.collada.org/2005/11/COLLADASchema";
  root.append_attribute("version") = "1.4.1";
  root.append_child("asset").append_child("up_axis").text() = "Y_UP";
  auto geometry = root.append_child("library_geometries").append_child("geometry");
  geometry.append_attribute("id") = "geometry";
  auto collada_mesh = geometry.append_child("mesh");
  add_positions(collada_mesh, mesh);
  add_polylist(collada_mesh, mesh);

  auto scene = root.append_child("library_visual_scenes").append_child("visual_scene");
  scene.append_attribute("id") = "scene";
  scene.append_child("node").append_child("instance_geometry").append_attribute("url") =
      "#geometry";
  root.append_child("scene").append_child("instance_visual_scene").append_attribute("url") =
      "#scene";
  std::ostringstream stream;
  document.save(stream, " ");
  return std::move(stream).str();
}

}  // namespace meshgrade
