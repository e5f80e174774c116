#include "grader/files/collada_geometry.h"

#include <algorithm>
#include <array>
#include <utility>

#include "grader/files/file_bytes.h"
#include "grader/files/triangle_strip.h"

namespace meshgrade {
namespace {

using Corners = std::vector<std::uint32_t>;

class GeometryReader {
 public:
  GeometryReader(const ColladaDocument& document, ReadingNotes& notes)
      : document_(document), notes_(notes) {}

  PolygonMesh read(const pugi::xml_node& geometry) {
    for (const auto& child : geometry.children()) {
      const std::string_view kind = child.name();
      if (kind == "mesh" || kind == "convex_mesh") {
        add_primitives(child);
        if (child.attribute("convex_hull_of")) {
          notes_.left_out("convex hull of another geometry", "convex hulls of other geometries",
                          document_.line_of(child));
        }
      } else if (kind == "spline") {
        notes_.left_out("spline", "splines", document_.line_of(child));
      } else if (kind == "brep") {
        notes_.left_out("solid of curved faces (brep)", "solids of curved faces (brep)",
                        document_.line_of(child));
      }
    }
    return std::move(mesh_);
  }

 private:
  /// One `input` of a primitive or of `vertices`.
  struct Input {
    pugi::xml_node source;
    std::size_t offset = 0;
  };

  void add_primitives(const pugi::xml_node& mesh) {
    for (const auto& child : mesh.children()) {
      const std::string_view kind = child.name();
      if (kind == "triangles" || kind == "polylist" || kind == "polygons" ||
          kind == "tristrips" || kind == "trifans") {
        add_polygons(child);
      } else if (kind == "lines") {
        notes_.left_out("line", "lines", document_.line_of(child),
                        document_.count_attribute(child, "count", 1));
      } else if (kind == "linestrips") {
        const auto strips = child.children("p");
        notes_.left_out("line strip", "line strips", document_.line_of(child),
                        static_cast<std::size_t>(std::distance(strips.begin(), strips.end())));
      }
    }
  }

  Input find_input(const pugi::xml_node& node, std::string_view semantic,
                   std::string_view kind) const {
    for (const auto& input : node.children("input")) {
      if (input.attribute("semantic").value() == semantic) {
        return {document_.referred(input, "source", {kind, "source"}),
                document_.count_attribute(input, "offset", 0)};
      }
    }
    document_.refuse(node, "has no input " + std::string(semantic));
  }

  /// Where x, y and z stand among the numbers of a point.
  static std::array<std::size_t, 3> axes_of(const pugi::xml_node& accessor) {
    std::array<std::size_t, 3> axes = {0, 1, 2};
    std::array<std::size_t, 3> named{};
    std::size_t n_named = 0;
    std::size_t at = 0;
    for (const auto& param : accessor.children("param")) {
      const std::string_view name = param.attribute("name").value();
      if (name == "X" || name == "Y" || name == "Z") {
        named[static_cast<std::size_t>(name[0] - 'X')] = at;
        ++n_named;
      }
      ++at;
    }
    if (n_named == 3) axes = named;
    return axes;
  }

  std::vector<Point3> source_points(const pugi::xml_node& source) const {
    const auto accessor = source.child("technique_common").child("accessor");
    const auto floats = source.child("float_array");
    const std::vector<double> values =
        document_.reals(floats ? floats : source.child("int_array"));
    const std::size_t stride = document_.count_attribute(accessor, "stride", 3);
    const std::size_t offset = document_.count_attribute(accessor, "offset", 0);
    if (stride < 3) document_.refuse(source, "positions need a stride of 3 or more");
    const auto axes = axes_of(accessor);
    const std::size_t last = *std::max_element(axes.begin(), axes.end());
    std::vector<Point3> points;
    for (std::size_t k = offset; k + last < values.size(); k += stride) {
      points.push_back({values[k + axes[0]], values[k + axes[1]], values[k + axes[2]]});
    }
    if (const std::size_t promised =
            document_.count_attribute(accessor, "count", points.size());
        promised > points.size()) {
      document_.refuse(source, "promises " + std::to_string(promised) +
                                   " positions and holds " + std::to_string(points.size()));
    }
    return points;
  }

  /// The points of one source, which several primitives may share.
  struct Points {
    pugi::xml_node source;
    std::size_t first;
    std::size_t count;
  };

  Points points_of(const pugi::xml_node& source) {
    const auto known = std::find_if(points_.begin(), points_.end(), [&](const Points& points) {
      return points.source == source;
    });
    if (known != points_.end()) return *known;
    const std::vector<Point3> read = source_points(source);
    points_.push_back({source, mesh_.positions.size(), read.size()});
    mesh_.positions.insert(mesh_.positions.end(), read.begin(), read.end());
    return points_.back();
  }

  /// The lists of numbers of a primitive: one for each polygon, strip or fan.
  std::vector<Corners> number_lists(const pugi::xml_node& primitive,
                                    std::size_t n_inputs) const {
    const std::string_view kind = primitive.name();
    std::vector<Corners> lists;
    if (kind == "polygons" || kind == "tristrips" || kind == "trifans") {
      if (primitive.child("ph")) {
        document_.refuse(primitive, "polygons with holes are not read");
      }
      for (const auto& p : primitive.children("p"))
        lists.push_back(document_.indices(p));
      return lists;
    }
    const Corners flat = document_.indices(primitive.child("p"));
    Corners sizes;
    if (kind == "polylist") {
      sizes = document_.indices(primitive.child("vcount"));
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
      document_.refuse(primitive, "its list p does not fit its " +
                                      std::to_string(sizes.size()) +
                                      " polygons; the file may be cut off");
    }
    return lists;
  }

  std::vector<Corners> polygons_of(const pugi::xml_node& primitive, const Corners& corners) {
    const std::string_view kind = primitive.name();
    if (kind == "tristrips") return cut_strips(corners);
    if (kind == "trifans") return cut_fan(corners);
    return {corners};
  }

  void add_polygons(const pugi::xml_node& primitive) {
    std::size_t n_inputs = 1;
    for (const auto& input : primitive.children("input")) {
      n_inputs = std::max(n_inputs, document_.count_attribute(input, "offset", 0) + 1);
    }
    const std::vector<Corners> lists = number_lists(primitive, n_inputs);
    if (lists.empty()) return;
    const Input vertices = find_input(primitive, "VERTEX", "vertices");
    const Points points = points_of(find_input(vertices.source, "POSITION", "source").source);
    const std::string place = document_.line_of(primitive);
    for (const Corners& list : lists) {
      Corners corners;
      for (std::size_t k = vertices.offset; k < list.size(); k += n_inputs)
        corners.push_back(list[k]);
      for (Corners& polygon : polygons_of(primitive, corners))
        add_polygon(place, std::move(polygon), points);
    }
  }

  void add_polygon(const std::string& place, Corners corners, const Points& points) {
    if (!admit_polygon(document_.file(), place, mesh_.polygons.size(), corners, points.count, 0,
                       notes_)) {
      return;
    }
    for (std::uint32_t& v : corners)
      v += static_cast<std::uint32_t>(points.first);
    mesh_.polygons.push_back(std::move(corners));
  }

  const ColladaDocument& document_;
  ReadingNotes& notes_;
  std::vector<Points> points_;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh collada_geometry(const ColladaDocument& document, const pugi::xml_node& geometry,
                             ReadingNotes& notes) {
  return GeometryReader(document, notes).read(geometry);
}

}  // namespace meshgrade
