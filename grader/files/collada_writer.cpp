#include <array>
#include <charconv>
#include <pugixml.hpp>
#include <sstream>

#include "grader/files/collada_file.h"

namespace meshgrade {
namespace {

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

void write_positions(pugi::xml_node collada_mesh, const PolygonMesh& mesh) {
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

std::string format_collada(const PolygonMesh& mesh) {
  pugi::xml_document document;
  auto root = document.append_child("COLLADA");
  root.append_attribute("xmlns") = "http://www.collada.org/2005/11/COLLADASchema";
  root.append_attribute("version") = "1.4.1";
  root.append_child("asset").append_child("up_axis").text() = "Y_UP";
  auto geometry = root.append_child("library_geometries").append_child("geometry");
  geometry.append_attribute("id") = "geometry";
  auto collada_mesh = geometry.append_child("mesh");
  write_positions(collada_mesh, mesh);
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
