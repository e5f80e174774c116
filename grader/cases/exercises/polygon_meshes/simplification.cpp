#include <algorithm>
#include <cmath>

#include "grader/base/text.h"
#include "grader/cases/case_list.h"
#include "grader/cases/mesh_shapes.h"
#include "grader/cases/moved_meshes.h"
#include "grader/cases/simplification_input.h"
#include "grader/cases/simplified_shapes.h"

namespace meshgrade {
namespace {

constexpr std::uint64_t kStepsPerFace = 6000;

std::string goal_text(double faces) {
  return "at most " + plural(static_cast<std::size_t>(std::floor(faces)), "face");
}

class SimplificationCases {
 public:
  explicit SimplificationCases(CaseMaker& maker) : maker_(maker) {}

  /// As many collapses as take two faces each. The goal is so far between two numbers of faces
  /// that rounding it does not change how many there are.
  void add_collapses(const std::string& group, const std::string& name, const PolygonMesh& mesh,
                     std::uint32_t n, std::uint32_t turns = 0) {
    const auto faces = static_cast<double>(mesh.polygons.size());
    add(group,
        {name, in_build_order(mesh), turns, (faces - 2.0 * n + 0.7) / faces,
         SimplifiedAs::kCheapest},
        plural(n, "collapse"));
  }

  /// One collapse of a mesh with a boundary, where it may take one face.
  void add_open(const std::string& group, const std::string& name, const PolygonMesh& mesh,
                std::uint32_t turns = 0) {
    const auto faces = static_cast<double>(mesh.polygons.size());
    add(group,
        {name, in_build_order(mesh), turns, (faces - 0.9) / faces, SimplifiedAs::kCheapest},
        "one collapse");
  }

  /// Down to a number of faces.
  void add_goal(const std::string& group, const std::string& name, const PolygonMesh& mesh,
                double goal, SimplifiedAs compared, std::uint32_t turns = 0) {
    const auto faces = static_cast<double>(mesh.polygons.size());
    add(group, {name, in_build_order(mesh), turns, (goal + 0.1) / faces, compared},
        goal_text(goal));
  }

  void add_unchanged(const std::string& group, const std::string& name, const PolygonMesh& mesh,
                     double ratio) {
    add(group, {name, in_build_order(mesh), 0, ratio, SimplifiedAs::kCheapest},
        "ratio " + number_text(ratio) + ", nothing to do");
  }

 private:
  void add(const std::string& group, const SimplificationInput& input,
           const std::string& what) {
    const std::string anchors = input.anchor_turns == 0 ? "" : ", each halfedge() another one";
    maker_.add(group, "simplify " + input.mesh_name + ": " + what + anchors,
               20'000 + kStepsPerFace * input.mesh.polygons.size(), input,
               {"PolyMesh::simplify"});
  }

  CaseMaker& maker_;
};

std::vector<std::string> closed_triangle_meshes() {
  return {"octahedron.off", "bipyramid_3.obj", "icosahedron.obj", "torus.ply",
          "double_torus.obj"};
}

void add_first_collapses(SimplificationCases& cases, CaseMaker& maker) {
  Random random = maker.random("first");
  for (const std::string& file : closed_triangle_meshes()) {
    for (const char* again : {"", ", once more"})
      cases.add_collapses("basic", file + ", shaken" + again, shaken(maker.mesh(file), random),
                          1);
  }
  for (const std::uint32_t n : {5U, 7U, 9U})
    cases.add_collapses("basic",
                        "a double pyramid with " + std::to_string(n) + " sides, shaken",
                        shaken(bipyramid(n), random), 1);
  cases.add_collapses("basic", "quad_cube.dae, its quads cut",
                      cut_in_four(cut_to_triangles(maker.mesh("quad_cube.dae"))), 1);
  cases.add_unchanged("basic", "icosahedron.obj", maker.mesh("icosahedron.obj"), 1.0);
  cases.add_unchanged("basic", "octahedron.off", maker.mesh("octahedron.off"), 1.5);
}

void add_several_collapses(SimplificationCases& cases, CaseMaker& maker) {
  Random random = maker.random("several");
  for (const std::uint32_t n : {2U, 3U, 4U, 6U, 8U}) {
    for (const char* file : {"icosahedron.obj", "torus.ply", "double_torus.obj"}) {
      const bool is_small = std::string(file) == "icosahedron.obj";
      cases.add_collapses("several", std::string(file) + ", shaken",
                          shaken(maker.mesh(file), random), is_small ? std::min(n, 4U) : n,
                          n % 3);
    }
  }
  cases.add_collapses("several", "an icosahedron cut in four, shaken",
                      shaken(cut_in_four(maker.mesh("icosahedron.obj")), random), 5);
}

void add_boundaries(SimplificationCases& cases, CaseMaker& maker) {
  Random random = maker.random("boundary");
  for (const char* file : {"grid_4x4.obj", "grid_hole.off", "cylinder.dae"}) {
    const PolygonMesh mesh = shaken(cut_to_triangles(maker.mesh(file)), random);
    cases.add_open("boundary", std::string(file) + ", shaken", mesh);
    cases.add_goal("boundary", std::string(file) + ", shaken", mesh,
                   0.6 * static_cast<double>(mesh.polygons.size()), SimplifiedAs::kAnything, 1);
  }
  for (const std::uint32_t n : {4U, 6U}) {
    const std::string name = "a square of " + std::to_string(2 * n * n) + " triangles";
    const PolygonMesh mesh = open_grid(n, random);
    cases.add_open("boundary", name, mesh, 1);
    cases.add_goal("boundary", name, mesh, n * n, SimplifiedAs::kAnything);
  }
  cases.add_goal("boundary", "a band of 60 triangles", winding_band(30), 30,
                 SimplifiedAs::kAnything);
}

void add_shapes(SimplificationCases& cases, CaseMaker& maker) {
  Random random = maker.random("shape");
  cases.add_goal("shape", "a flat piece", flat_patch(6, random), 30, SimplifiedAs::kSame);
  cases.add_goal("shape", "a roof", roof(4), 30, SimplifiedAs::kSame);
  const PolygonMesh cube = cut_in_four(cut_to_triangles(maker.mesh("quad_cube.dae")));
  cases.add_goal("shape", "a cube of 48 triangles", cube, 12, SimplifiedAs::kSame);
  cases.add_goal("shape", "a cube of 192 triangles", cut_in_four(cube), 12,
                 SimplifiedAs::kSame);
  cases.add_goal("shape", "a tetrahedron of 64 triangles",
                 cut_in_four(cut_in_four(maker.mesh("tetrahedron.obj"))), 4,
                 SimplifiedAs::kSame);
  for (std::uint32_t which = 0; which < kBumpyShapes; ++which) {
    const PolygonMesh mesh = bumpy_shape(which);
    cases.add_goal("shape", bumpy_shape_name(which), mesh,
                   std::floor(0.15 * static_cast<double>(mesh.polygons.size())),
                   SimplifiedAs::kSimilar);
  }
}

void add_refused(SimplificationCases& cases, CaseMaker& maker) {
  Random random = maker.random("refused");
  for (const std::uint32_t n : {1U, 2U, 3U})
    cases.add_collapses("refused", "an hourglass", hourglass(), n, n - 1);
  for (const std::uint32_t n : {10U, 16U})
    cases.add_goal("refused", "a band of " + std::to_string(2 * n) + " triangles",
                   winding_band(n), n + 4.0, SimplifiedAs::kAnything);
  for (const char* file : {"tetrahedron.obj", "single_triangle.obj"})
    cases.add_goal("refused", file, maker.mesh(file), 0, SimplifiedAs::kAnything);
  for (const char* file : {"octahedron.off", "bipyramid_3.obj", "two_triangles.obj"}) {
    cases.add_goal("refused", std::string(file) + ", shaken", shaken(maker.mesh(file), random),
                   0, SimplifiedAs::kAnything, 1);
  }
}

void add_stress(SimplificationCases& cases, CaseMaker& maker) {
  Random random = maker.random("stress");
  for (const std::uint32_t turns : {1U, 2U})
    cases.add_collapses("stress", "icosahedron.obj, shaken",
                        shaken(maker.mesh("icosahedron.obj"), random), 2, turns);
  const PolygonMesh mesh = shaken(maker.mesh("icosahedron.obj"), random);
  for (const MovedMesh& moved : moved_meshes(in_build_order(mesh), {0, 1}))
    cases.add_collapses("stress", "icosahedron.obj, shaken, " + moved.how, moved.mesh, 3);
  cases.add_collapses(
      "stress", "an icosahedron and an octahedron",
      shaken(side_by_side(maker.mesh("icosahedron.obj"), maker.mesh("octahedron.off")), random),
      4);
  cases.add_collapses("stress", "double pyramids with 5 to 12 sides",
                      many_valences(5, 12, random), 3, 1);
  cases.add_goal("stress", "two_components.obj",
                 cut_to_triangles(maker.mesh("two_components.obj")), 6,
                 SimplifiedAs::kAnything);
  cases.add_goal("stress", "a square of 98 triangles", open_grid(7, random), 40,
                 SimplifiedAs::kAnything);
  cases.add_goal("stress", "a square of 5000 triangles", open_grid(50, random), 1000,
                 SimplifiedAs::kAnything);
}

}  // namespace

void make_simplification_cases(CaseMaker& maker) {
  SimplificationCases cases(maker);
  add_first_collapses(cases, maker);
  add_several_collapses(cases, maker);
  add_boundaries(cases, maker);
  add_refused(cases, maker);
  add_shapes(cases, maker);
  add_stress(cases, maker);
}

void shrink_simplification_case(CaseMaker& maker, const Case& failed) {
  SimplificationCases cases(maker);
  const auto input = from_wire<SimplificationInput>(failed.input);
  if (input.compared != SimplifiedAs::kCheapest || input.ratio >= 1.0) return;
  Random random = maker.random("smaller");
  for (const char* file : {"octahedron.off", "icosahedron.obj"}) {
    const PolygonMesh mesh = shaken(maker.mesh(file), random);
    if (mesh.polygons.size() >= input.mesh.polygons.size()) continue;
    for (const std::uint32_t n : {1U, 2U})
      cases.add_collapses(failed.group, std::string(file) + ", shaken", mesh, n,
                          input.anchor_turns);
  }
}

}  // namespace meshgrade
