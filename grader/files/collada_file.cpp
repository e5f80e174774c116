#include "grader/files/collada_file.h"

#include <cmath>
#include <map>
#include <numbers>

#include "grader/files/collada_document.h"
#include "grader/files/collada_geometry.h"
#include "grader/files/file_bytes.h"
#include "grader/files/scene.h"

namespace meshgrade {
namespace {

constexpr int kDeepestNodes = 64;
constexpr std::size_t kMostNodes = 100'000;

/// What places a node. Transforms that are not read matter only where a geometry hangs on them.
struct Placement {
  Transform transform;
  pugi::xml_node unread;
};

/// Turns and moves a thing from the origin, seen along -z, to `eye`, seen towards `target`.
Transform look_at(const std::vector<double>& v) {
  const Point3 eye = {v[0], v[1], v[2]};
  const auto unit = [](Point3 a) {
    const double length = std::hypot(a[0], a[1], a[2]);
    return Point3{a[0] / length, a[1] / length, a[2] / length};
  };
  const auto cross = [](const Point3& a, const Point3& b) {
    return Point3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                  a[0] * b[1] - a[1] * b[0]};
  };
  const Point3 back = unit({v[0] - v[3], v[1] - v[4], v[2] - v[5]});
  const Point3 right = unit(cross({v[6], v[7], v[8]}, back));
  const Point3 up = cross(back, right);
  Transform transform;
  for (std::size_t r = 0; r < 3; ++r)
    transform.rows[r] = {right[r], up[r], back[r], eye[r]};
  return transform;
}

class ColladaSceneReader {
 public:
  explicit ColladaSceneReader(const ColladaDocument& document) : document_(document) {}

  LoadedMesh read() {
    const Placement up{up_axis(), {}};
    if (const pugi::xml_node scene = visual_scene()) {
      for (const auto& node : scene.children("node"))
        add_node(node, up, 0);
      count_unseen();
    } else {
      for (const auto& library : document_.root().children("library_geometries")) {
        for (const auto& geometry : library.children("geometry"))
          add_geometry(geometry, geometry, up);
      }
    }
    return {std::move(whole_), notes_.all()};
  }

 private:
  /// The scene that the file shows; else, if it says nothing, its first.
  pugi::xml_node visual_scene() const {
    const pugi::xml_node root = document_.root();
    if (const auto scene = root.child("scene").child("instance_visual_scene")) {
      return document_.referred(scene, "url", {"visual_scene"});
    }
    return root.child("library_visual_scenes").child("visual_scene");
  }

  void count_unseen() {
    for (const auto& library : document_.root().children("library_geometries")) {
      for (const auto& geometry : library.children("geometry")) {
        if (meshes_.contains(geometry.internal_object())) continue;
        notes_.left_out("geometry that the scene does not show",
                        "geometries that the scene does not show", document_.line_of(geometry));
      }
    }
  }

  void add_geometry(const pugi::xml_node& geometry, const pugi::xml_node& at,
                    const Placement& placement) {
    if (placement.unread) {
      document_.refuse(placement.unread, std::string(placement.unread.name()) +
                                             " is not read; export with a matrix");
    }
    const auto [entry, is_new] = meshes_.try_emplace(geometry.internal_object());
    if (is_new) entry->second = collada_geometry(document_, geometry, notes_);
    append_part(whole_, entry->second, placement.transform, document_.file(),
                document_.line_of(at));
  }

  Transform one_transform(const pugi::xml_node& node) const {
    const std::string_view kind = node.name();
    if (kind == "translate" || kind == "scale") {
      const auto v = document_.reals(node, 3);
      const Point3 by = {v[0], v[1], v[2]};
      return kind == "scale" ? scaling(by) : translation(by);
    }
    if (kind == "rotate") {
      const auto v = document_.reals(node, 4);
      const bool has_axis = v[0] != 0 || v[1] != 0 || v[2] != 0;
      return has_axis ? rotation({v[0], v[1], v[2]}, v[3] * std::numbers::pi / 180)
                      : Transform();
    }
    if (kind == "lookat") return look_at(document_.reals(node, 9));
    Transform transform;
    if (kind == "matrix") {
      const auto v = document_.reals(node, 16);
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 4; ++c)
          transform.rows[r][c] = v[r * 4 + c];
      }
    }
    return transform;
  }

  void add_node(const pugi::xml_node& node, const Placement& parent, int depth) {
    if (depth > kDeepestNodes || ++n_nodes_ > kMostNodes) {
      document_.refuse(node, "the nodes are nested too deeply, or in a circle");
    }
    Placement placement = parent;
    for (const auto& child : node.children()) {
      placement.transform = placement.transform * one_transform(child);
      if (std::string_view(child.name()) == "skew" && !placement.unread) {
        placement.unread = child;
      }
    }
    for (const auto& child : node.children()) {
      const std::string_view kind = child.name();
      if (kind == "node") {
        add_node(child, placement, depth + 1);
      } else if (kind == "instance_node") {
        add_node(document_.referred(child, "url", {"node"}), placement, depth + 1);
      } else if (kind == "instance_geometry") {
        add_geometry(document_.referred(child, "url", {"geometry"}), child, placement);
      } else if (kind == "instance_controller") {
        document_.refuse(child,
                         "skins and morphs of COLLADA are not read; export the plain geometry");
      }
    }
  }

  Transform up_axis() const {
    const std::string text = text_of(document_.root().child("asset").child("up_axis"));
    Transform turn;
    if (text.find("Z_UP") != text.npos) {
      turn.rows = {{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}}};
    } else if (text.find("X_UP") != text.npos) {
      turn.rows = {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}}};
    }
    return turn;
  }

  const ColladaDocument& document_;
  std::map<const void*, PolygonMesh> meshes_;  // by geometry
  ReadingNotes notes_;
  PolygonMesh whole_;
  std::size_t n_nodes_ = 0;
};

}  // namespace

LoadedMesh parse_collada(const std::filesystem::path& file, const std::string& bytes) {
  const ColladaDocument document(file, bytes);
  return ColladaSceneReader(document).read();
}

}  // namespace meshgrade
