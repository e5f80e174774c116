#include "grader/cases/placement_cases.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "grader/cases/moved_meshes.h"
#include "grader/operations/local_operation_list.h"
#include "grader/operations/picked_element.h"

namespace meshgrade {
namespace {

/// Handle uses that a good solution never needs for one call.
constexpr std::uint64_t kPlacementBudget = 20'000;

/// The faces of an answer as a mesh, its vertices in build order.
PolygonMesh as_polygons(const FaceLists& lists) {
  PolygonMesh mesh;
  std::map<Label, std::uint32_t> numbers;
  for (const Corners& corners : lists.faces) {
    auto& polygon = mesh.polygons.emplace_back();
    for (Label label : corners) {
      const auto [place, is_new] =
          numbers.try_emplace(label, static_cast<std::uint32_t>(numbers.size()));
      if (is_new) mesh.positions.push_back(lists.positions[label]);
      polygon.push_back(place->second);
    }
  }
  return mesh;
}

/// Of all faces; sides without a length, as operations leave them, do not count.
double shortest_side(const PlacementInput& face) {
  double shortest = HUGE_VAL;
  for (const std::vector<std::uint32_t>& corners : face.mesh.polygons) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point3& a = face.mesh.positions[corners[i]];
      const Point3& b = face.mesh.positions[corners[(i + 1) % corners.size()]];
      const double length = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      if (length > 0.0) shortest = std::min(shortest, length);
    }
  }
  return shortest;
}

class PlacementCases {
 public:
  PlacementCases(CaseMaker& maker, const PlacementExercise& exercise)
      : maker_(maker), exercise_(exercise), random_(maker.random("placements")) {}

  /// The faces that an operation makes of at most so many elements of a mesh.
  std::vector<PlacementInput> faces_of(const std::string& name, const PolygonMesh& mesh,
                                       std::size_t most) const {
    std::vector<PlacementInput> faces;
    const MeshDump built = built_mesh(mesh);
    const FaceLists lists = face_lists_of(built);
    for (const std::string& operation_name : exercise_.operations) {
      const LocalOperation& operation = *find_local_operation(operation_name);
      const std::uint32_t n = count_elements(built, operation.picks);
      const auto step = std::max<std::uint32_t>(1, n / static_cast<std::uint32_t>(most));
      for (std::uint32_t place = 0; place < n; place += step) {
        const Answer answer = operation.answer(lists, pick(built, operation.picks, place));
        if (answer.demand != Demand::kMust) continue;
        const std::string element =
            element_name(operation.picks, find_element(built, operation.picks, place));
        faces.push_back(face_of(answer, element + " of " + name + ", " + exercise_.done));
      }
    }
    return faces;
  }

  void add_file(const std::string& group, const std::string& file, std::size_t calls,
                std::size_t most, std::uint32_t anchor_turns = 0) {
    for (PlacementInput& face : faces_of(file, maker_.mesh(file), most))
      add(group, face, drawn(face, calls), anchor_turns);
  }

  /// The same call twice: whoever begins where the first one ended is further on.
  void add_twice(const std::string& file, std::size_t most) {
    for (PlacementInput& face : faces_of(file, maker_.mesh(file), most)) {
      const std::vector<Placement> once = drawn(face, 1);
      add("again", face, {once[0], once[0]}, 0);
    }
  }

  void add_moved(const std::string& file) {
    std::uint32_t turns = 0;
    const PolygonMesh mesh = shaken(maker_.mesh(file), random_);
    for (const MovedMesh& moved : moved_meshes(mesh, {0, 1})) {
      for (PlacementInput& face : faces_of(file + ", shaken, " + moved.how, moved.mesh, 2))
        add("stress", face, drawn(face, 2), turns++ % 3);
    }
  }

 private:
  static PlacementInput face_of(const Answer& answer, std::string name) {
    const auto is_it = [&](const Corners& corners) {
      return canonical(corners) == canonical(answer.returned[0]);
    };
    const auto& all = answer.after.faces;
    const auto face = std::find_if(all.begin(), all.end(), is_it) - all.begin();
    return {
        std::move(name), as_polygons(answer.after), 0, static_cast<std::uint32_t>(face), {}};
  }

  std::vector<Placement> drawn(const PlacementInput& face, std::size_t n) {
    const double size = shortest_side(face);
    std::vector<Placement> calls;
    for (std::size_t i = 0; i < n; ++i)
      calls.push_back(exercise_.draw(face, size, random_));
    return calls;
  }

  void add(const std::string& group, PlacementInput& face, std::vector<Placement> calls,
           std::uint32_t anchor_turns) {
    face.calls = std::move(calls);
    face.anchor_turns = anchor_turns;
    std::string title = "place the corners of " + face.mesh_name;
    if (face.calls.size() > 1) title += ", " + std::to_string(face.calls.size()) + " times";
    if (anchor_turns > 0) title += ", with other anchors";
    maker_.add(group, title, face.calls.size() * kPlacementBudget, face, {exercise_.function});
  }

  CaseMaker& maker_;
  const PlacementExercise& exercise_;
  Random random_;
};

}  // namespace

std::vector<RingCorner> ring_of(const PolygonMesh& mesh, std::uint32_t face) {
  const std::vector<std::uint32_t>& corners = mesh.polygons[face];
  const std::set<std::uint32_t> inside(corners.begin(), corners.end());
  std::map<std::uint32_t, std::uint32_t> outer;
  for (const std::vector<std::uint32_t>& polygon : mesh.polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::uint32_t a = polygon[i];
      const std::uint32_t b = polygon[(i + 1) % polygon.size()];
      if (inside.count(a) != 0 && inside.count(b) == 0) outer[a] = b;
      if (inside.count(b) != 0 && inside.count(a) == 0) outer[b] = a;
    }
  }
  std::vector<RingCorner> ring;
  for (std::uint32_t corner : corners)
    ring.push_back({corner, outer.at(corner)});
  return ring;
}

void make_placement_cases(CaseMaker& maker, const PlacementExercise& exercise) {
  PlacementCases cases(maker, exercise);
  for (const char* file : {"quad_cube.dae", "prism_5.obj", "octahedron.off", "dodecahedron.obj",
                           "mixed_strip.obj", "quad_grid_3x3.obj", "tube_6.obj"})
    cases.add_file("basic", file, 1, 4);
  for (const char* file : {"quad_cube.dae", "prism_5.obj", "mixed_strip.obj"}) {
    cases.add_twice(file, 3);
    cases.add_file("again", file, 4, 3);
  }
  for (const char* file : {"prism_5.obj", "dodecahedron.obj", "mixed_strip.obj"})
    for (const std::uint32_t turns : {1U, 2U})
      cases.add_file("stress", file, 2, 3, turns);
  for (const char* file : {"prism_5.obj", "quad_torus.obj"})
    cases.add_moved(file);
}

}  // namespace meshgrade
