#include "grader/build/scotty3d_classes.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "grader/submission/code_only.h"
#include "grader/submission/function_extents.h"
#include "grader/submission/scotty3d_files.h"

namespace meshgrade {
namespace {

using Words = std::set<std::string>;

constexpr const char* kMeshPrefix = "Halfedge_Mesh::";

Words words_in(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

// Of geometry/halfedge.h, without the graded functions.

const Words& mesh_members_since_2022() {
  static const Words members = words_in(
      "Vertex Edge Face Halfedge Index VertexRef VertexCRef EdgeRef EdgeCRef FaceRef FaceCRef "
      "HalfedgeRef HalfedgeCRef ElementRef ElementCRef Bone_Weight vertices edges faces "
      "halfedges copy swap emplace_vertex emplace_edge emplace_face emplace_halfedge "
      "erase_vertex erase_edge erase_face erase_halfedge interpolate_data "
      "Isotropic_Remesh_Parameters n_boundaries radius id_of center_of normal_of describe "
      "validate from_indexed_faces cube catmark_subdivide_helper");
  return members;
}

using Classes = std::map<std::string, Words>;

const Classes& members_since_2022() {
  static const Classes members{
      {"Vertex",
       {"halfedge", "id", "position", "bone_weights", "Bone_Weight", "on_boundary", "degree",
        "normal", "neighborhood_center", "angle_defect", "gaussian_curvature"}},
      {"Edge", {"halfedge", "id", "sharp", "on_boundary", "center", "normal", "length"}},
      {"Face", {"halfedge", "id", "boundary", "center", "normal", "degree", "area"}},
      {"Halfedge",
       {"twin", "next", "vertex", "edge", "face", "id", "corner_uv", "corner_normal",
        "set_tnvef"}},
      {"Halfedge_Mesh", mesh_members_since_2022()}};
  return members;
}

/// With what the course's own program uses, and the grader does not have.
const Words& mesh_members_until_2022() {
  static const Words members = words_in(
      "Vertex Edge Face Halfedge Index Size VertexRef VertexCRef EdgeRef EdgeCRef FaceRef "
      "FaceCRef HalfedgeRef HalfedgeCRef ElementRef ElementCRef vertices edges faces halfedges "
      "new_vertex new_edge new_face new_halfedge erase do_erase vertices_begin vertices_end "
      "edges_begin edges_end faces_begin faces_end halfedges_begin halfedges_end n_vertices "
      "n_edges n_faces n_halfedges has_boundary n_boundaries bevel_vertex_positions "
      "bevel_edge_positions bevel_face_positions bisect_edge inset_face extrude_vertex "
      "isotropic_remesh simplify collapse_edge_erase validate warnings flipped flip mark_dirty "
      "normal_of center_of id_of next_id flip_orientation render_dirty_flag verased eerased "
      "ferased herased copy_to clear subdivide to_mesh from_poly from_mesh");
  return members;
}

const Classes& members_until_2022() {
  static const Classes members{
      {"Vertex",
       {"halfedge", "on_boundary", "degree", "normal", "center", "neighborhood_center", "id",
        "pos", "new_pos", "is_new", "_id", "_halfedge"}},
      {"Edge",
       {"halfedge", "on_boundary", "center", "normal", "length", "id", "new_pos", "is_new",
        "_id", "_halfedge"}},
      {"Face",
       {"halfedge", "is_boundary", "center", "normal", "degree", "id", "new_pos", "_id",
        "_halfedge", "boundary"}},
      {"Halfedge",
       {"twin", "next", "vertex", "edge", "face", "id", "is_boundary", "set_neighbors", "_id",
        "_twin", "_next", "_vertex", "_edge", "_face"}},
      {"Halfedge_Mesh", mesh_members_until_2022()}};
  return members;
}

const Classes& our_members(Dialect dialect) {
  return dialect == Dialect::kScotty3d2020 ? members_until_2022() : members_since_2022();
}

bool is_ours(const std::string& class_name, const std::string& name, Dialect dialect) {
  const auto known = our_members(dialect).find(class_name);
  return known != our_members(dialect).end() &&
         (known->second.count(name) != 0 ||
          (class_name == "Halfedge_Mesh" &&
           scotty3d_graded_functions(dialect).count(kMeshPrefix + name) != 0));
}

int line_at(const std::string& text, std::size_t offset) {
  return 1 + static_cast<int>(std::count(
                 text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

}  // namespace

const std::map<std::string, std::string>& scotty3d_open_classes() {
  static const std::map<std::string, std::string> files{
      {"Vertex", "scotty3d_added_vertex.h"},
      {"Edge", "scotty3d_added_edge.h"},
      {"Face", "scotty3d_added_face.h"},
      {"Halfedge", "scotty3d_added_halfedge.h"},
      {"Halfedge_Mesh", "scotty3d_added_mesh.h"}};
  return files;
}

bool is_in_our_scotty3d_class(const ClassMember& member, Dialect dialect) {
  return std::all_of(member.names.begin(), member.names.end(), [&](const std::string& name) {
    return is_ours(member.class_name, name, dialect);
  });
}

std::string without_scotty3d_mesh(const std::string& name) {
  const std::string prefix = kMeshPrefix;
  const std::string rest = name.rfind(prefix, 0) == 0 ? name.substr(prefix.size()) : "";
  return rest.find("::") == std::string::npos ? name : rest;
}

std::vector<AddedPiece> scotty3d_members_defined(
    const std::vector<SourceFile>& sources, Dialect dialect,
    const std::set<std::pair<std::string, std::string>>& declared) {
  std::vector<AddedPiece> members;
  for (const SourceFile& source : sources) {
    for (const FunctionExtent& function : find_functions(source.text)) {
      const std::string name = without_scotty3d_mesh(function.name);
      const std::size_t colons = name.find("::");
      if (colons == std::string::npos) continue;
      const std::string class_name = name.substr(0, colons);
      const std::string last = name.substr(colons + 2);
      const bool is_plain = last.find_first_of(":~") == std::string::npos &&
                            last != class_name && last.rfind("operator", 0) != 0;
      if (!is_plain || our_members(dialect).count(class_name) == 0 ||
          is_ours(class_name, last, dialect) || declared.count({class_name, last}) != 0) {
        continue;
      }
      std::string head =
          code_only(source.text.substr(function.begin, function.body - function.begin));
      head.replace(head.find(function.name), function.name.size(), last);
      const int line = line_at(source.text, function.begin);
      const int last_line = line_at(source.text, function.body);
      members.push_back(
          {source.name,
           {class_name, MemberKind::kFunction, {last}, 0, head + ";", line, last_line},
           false});
    }
  }
  return members;
}

bool is_provided_by_scotty3d(const std::string& name) {
  static const Words provided{"add_face",
                              "bisect_edge",
                              "flip_orientation",
                              "set_corner_normals",
                              "set_corner_uvs_per_face",
                              "set_corner_uvs_project"};
  return provided.count(name) != 0;
}

std::vector<SourceFile> scotty3d_added_files(const std::map<std::string, std::string>& by_class,
                                             const std::string& later) {
  std::vector<SourceFile> files;
  for (const auto& [class_name, file] : scotty3d_open_classes()) {
    const auto text = by_class.find(class_name);
    files.push_back({file, text == by_class.end() ? "" : text->second});
  }
  files.push_back({"scotty3d_added_after.h", later});
  return files;
}

}  // namespace meshgrade
