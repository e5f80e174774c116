#include "grader/cases/whole_mesh_cases.h"

#include <algorithm>
#include <set>
#include <utility>

#include "grader/cases/mesh_shapes.h"
#include "grader/cases/moved_meshes.h"
#include "grader/cases/whole_mesh_input.h"

namespace meshgrade {
namespace {

std::string turned_anchors_text(std::uint32_t turns) {
  if (turns == 0) return {};
  return turns == 1 ? ", each halfedge() the next one" : ", each halfedge() the one after next";
}

/// Whether an edge has a face on one side only.
bool has_boundary(const PolygonMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& corners : mesh.polygons) {
    for (std::size_t i = 0; i < corners.size(); ++i)
      sides.insert({corners[i], corners[(i + 1) % corners.size()]});
  }
  return std::any_of(sides.begin(), sides.end(), [&](const auto& side) {
    return sides.count({side.second, side.first}) == 0;
  });
}

std::size_t corners_of_all(const PolygonMesh& mesh) {
  std::size_t n = 0;
  for (const auto& corners : mesh.polygons)
    n += corners.size();
  return n;
}

class WholeMeshCases {
 public:
  WholeMeshCases(CaseMaker& maker, const WholeMeshExercise& exercise)
      : maker_(maker), exercise_(exercise) {}

  void add_file(const std::string& group, const std::string& file, std::uint32_t times,
                std::uint32_t anchor_turns = 0) {
    add(group, file, maker_.mesh(file), times, anchor_turns);
  }

  void add(const std::string& group, const std::string& name, const PolygonMesh& mesh,
           std::uint32_t times, std::uint32_t anchor_turns = 0) {
    const WholeMeshInput input = input_for(name, mesh, times, anchor_turns);
    maker_.add(group_for(group, mesh), title(input), budget(input), input,
               {exercise_.function});
  }

  /// In a process in which nothing was called before: a function may be wrong at its third call
  /// only.
  void add_fresh(const std::string& group, const std::string& name, const PolygonMesh& mesh,
                 std::uint32_t times, std::uint32_t anchor_turns = 0) {
    const WholeMeshInput input = input_for(name, mesh, times, anchor_turns);
    maker_.add_fresh(group_for(group, mesh), title(input) + ", before anything else",
                     budget(input), input, {exercise_.function});
  }

  /// A shaken mesh larger, smaller, elsewhere, turned and mirrored: twice, where the exercise
  /// goes on with what came of it.
  void add_moved(const std::string& group, const std::string& name, const PolygonMesh& mesh) {
    std::uint32_t turns = 0;
    for (const MovedMesh& moved : moved_meshes(mesh, {0, 1}))
      add(group, name + ", shaken, " + moved.how, moved.mesh, at_most(2), turns++ % 3);
  }

  std::uint32_t at_most(std::uint32_t times) const {
    return std::min(times, exercise_.most_times);
  }

  /// Whether it must be done on a mesh.
  bool takes(const PolygonMesh& mesh) const {
    return exercise_.takes == nullptr || exercise_.takes(mesh);
  }

 private:
  WholeMeshInput input_for(const std::string& name, const PolygonMesh& mesh,
                           std::uint32_t times, std::uint32_t anchor_turns) const {
    return {name, in_build_order(mesh), anchor_turns, takes(mesh) ? times : 1};
  }

  std::string group_for(const std::string& group, const PolygonMesh& mesh) const {
    return takes(mesh) ? group : "refused";
  }

  std::string title(const WholeMeshInput& input) const {
    return exercise_.title(input.times, input.mesh_name) +
           turned_anchors_text(input.anchor_turns);
  }

  /// For all levels together: each has at most four times the corners of the one before, or, if
  /// it is the first, of its polygons.
  std::uint64_t budget(const WholeMeshInput& input) const {
    const std::uint64_t corners = corners_of_all(input.mesh) << (2U * (input.times - 1));
    return 10'000 + 2 * exercise_.steps_per_corner * corners;
  }

  CaseMaker& maker_;
  const WholeMeshExercise& exercise_;
};

const std::vector<std::string>& closed_polygon_meshes() {
  static const std::vector<std::string> files{
      "tetrahedron.obj", "quad_cube.dae",  "prism_5.obj",     "pyramid_4.obj",
      "octahedron.off",  "quad_torus.obj", "icosahedron.obj", "dodecahedron.obj",
      "bipyramid_3.obj", "lens.obj",       "pouch.obj",       "valence_zoo.obj"};
  return files;
}

const std::vector<std::string>& open_polygon_meshes() {
  static const std::vector<std::string> files{
      "single_triangle.obj", "single_quad.obj",   "two_triangles.obj", "fan.obj",
      "mixed_strip.obj",     "quad_grid_3x3.obj", "tube_6.obj",        "ring_5.obj",
      "umbrella.obj",        "grid_hole.off"};
  return files;
}

/// Prisms side by side, shaken: two faces with each number of corners from `first` to `last`.
PolygonMesh many_sides(std::uint32_t first, std::uint32_t last, Random& random) {
  PolygonMesh all = shaken(prism(first), random);
  for (std::uint32_t n = first + 1; n <= last; ++n)
    all = side_by_side(shaken(prism(n), random), all);
  return all;
}

void add_stress(WholeMeshCases& cases, CaseMaker& maker, std::uint32_t few_times) {
  for (const char* file : {"prism_5.obj", "dodecahedron.obj", "quad_torus.obj",
                           "valence_zoo.obj", "octahedron.off"})
    for (const std::uint32_t turns : {1U, 2U})
      cases.add_file("stress", file, few_times, turns);
  Random random = maker.random("moved");
  const PolygonMesh closed =
      shaken(side_by_side(maker.mesh("prism_5.obj"), maker.mesh("octahedron.off")), random);
  cases.add_moved("stress", "prism_5.obj and octahedron.off", closed);
  cases.add_moved("stress", "octahedron.off", shaken(maker.mesh("octahedron.off"), random));
  const PolygonMesh fresh = shaken(maker.mesh("valence_zoo.obj"), random);
  for (const std::uint32_t turns : {0U, 1U})
    cases.add_fresh("stress", "valence_zoo.obj, shaken", fresh, cases.at_most(3), turns);
  const PolygonMesh sides = many_sides(3, 12, random);
  cases.add_fresh("stress", "prisms with 3 to 12 sides", sides, few_times);
  cases.add("stress", "prisms with 13 to 24 sides", many_sides(13, 24, random), 1, 1);
  cases.add("stress", "double pyramids with 3 to 12 sides", many_valences(3, 12, random), 1, 2);
  cases.add("stress", "double pyramids with 13 to 24 sides",
            beginning_at_highest_valence(many_valences(13, 24, random)), 1);
  cases.add("stress", "an octahedron inside a cube 1000 times as large",
            two_sizes(maker.mesh("octahedron.off"), maker.mesh("quad_cube.dae"), random),
            few_times);
}

void add_boundaries(WholeMeshCases& cases, CaseMaker& maker, std::uint32_t few_times) {
  std::uint32_t turns = 0;
  for (const std::string& file : open_polygon_meshes()) {
    cases.add_file("boundary", file, 1);
    cases.add_file("boundary", file, few_times, 1 + turns++ % 2);
  }
  Random random = maker.random("boundaries");
  for (const char* file : {"mixed_strip.obj", "fan.obj"}) {
    const PolygonMesh mesh = shaken(maker.mesh(file), random);
    cases.add_moved("boundary", file, mesh);
    for (const std::uint32_t turned : {0U, 1U})
      cases.add_fresh("boundary", std::string(file) + ", shaken", mesh, cases.at_most(3),
                      turned);
  }
  cases.add_fresh("boundary", "grid_hole.off, shaken",
                  shaken(maker.mesh("grid_hole.off"), random), few_times, 2);
  cases.add("boundary", "a fan of 22 triangles",
            beginning_at_highest_valence(shaken(open_fan(22), random)), 1);
  cases.add(
      "boundary", "a tube and a strip",
      shaken(side_by_side(maker.mesh("tube_6.obj"), maker.mesh("mixed_strip.obj")), random),
      few_times);
  cases.add("boundary", "a grid of 10,000 quads", shaken(quad_grid(100, 100), random), 1);
  cases.add("boundary", "a square of 5000 triangles", open_grid(50, random), 1);
}

}  // namespace

void make_whole_mesh_cases(CaseMaker& maker, const WholeMeshExercise& exercise) {
  WholeMeshCases cases(maker, exercise);
  const std::uint32_t few_times = cases.at_most(2);
  for (const std::string& file : closed_polygon_meshes())
    cases.add_file("basic", file, 1);
  Random random = maker.random("shaken");
  for (const char* file : {"prism_5.obj", "dodecahedron.obj", "valence_zoo.obj"})
    cases.add("basic", std::string(file) + ", shaken", shaken(maker.mesh(file), random), 1);
  for (std::uint32_t times = 2; times <= exercise.most_times; ++times) {
    cases.add_file("levels", "quad_cube.dae", times);
    cases.add_file("levels", times < 4 ? "prism_5.obj" : "pyramid_4.obj", times, times % 3);
    cases.add("levels", "bipyramid_3.obj, shaken",
              shaken(maker.mesh("bipyramid_3.obj"), random), times);
    cases.add_file("levels", "octahedron.off", times, 1);
  }
  add_boundaries(cases, maker, few_times);
  add_stress(cases, maker, few_times);
}

void shrink_whole_mesh_case(CaseMaker& maker, const WholeMeshExercise& exercise,
                            const Case& failed) {
  WholeMeshCases cases(maker, exercise);
  const auto input = from_wire<WholeMeshInput>(failed.input);
  const std::size_t corners = corners_of_all(input.mesh);
  const bool is_open = has_boundary(input.mesh);
  const bool is_taken = cases.takes(input.mesh);
  for (std::uint32_t times = 1; times < input.times; ++times)
    cases.add(failed.group, input.mesh_name, input.mesh, times, input.anchor_turns);
  for (const std::string& file : is_open ? open_polygon_meshes() : closed_polygon_meshes()) {
    const PolygonMesh mesh = maker.mesh(file);
    if (corners_of_all(mesh) >= corners || cases.takes(mesh) != is_taken) continue;
    cases.add(failed.group, file, mesh, input.times, input.anchor_turns);
  }
  // What depends on the number of corners or of edges at a vertex is seen in the least of them.
  for (std::uint32_t n = 5; !is_open && 6 * n < corners && n <= 24; ++n) {
    const std::string sides = std::to_string(n) + " sides";
    for (const auto& [name, mesh] :
         {std::pair("a prism with " + sides, prism(n)),
          std::pair("a double pyramid with " + sides, bipyramid(n))}) {
      if (cases.takes(mesh) == is_taken)
        cases.add(failed.group, name, mesh, input.times, input.anchor_turns);
    }
  }
}

}  // namespace meshgrade
