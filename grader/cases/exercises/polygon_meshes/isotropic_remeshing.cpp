#include "grader/base/text.h"
#include "grader/cases/case_list.h"
#include "grader/cases/mesh_ladder.h"
#include "grader/cases/moved_meshes.h"
#include "grader/cases/remesh_meshes.h"
#include "grader/mesh/torus_mesh.h"

namespace meshgrade {
namespace {

std::string settings_text(const RemeshSettings& settings) {
  if (settings.outer == 0) return "no round";
  std::string text = plural(settings.outer, "round");
  if (settings.longer < kNeverLonger)
    text += ", longer than " + number_text(settings.longer, 3) + " L";
  if (settings.shorter > 0.0)
    text += ", shorter than " + number_text(settings.shorter, 3) + " L";
  if (settings.smoothing > 0) {
    text += ", smoothed " +
            (settings.smoothing == 1 ? "once" : std::to_string(settings.smoothing) + " times") +
            " by " + number_text(settings.step, 3);
  }
  return text;
}

/// Handle uses that a good solution never needs: for each edge that there may be some hundred,
/// and some dozens for each time that it is smoothed.
std::uint64_t remesh_budget(const RemeshInput& input) {
  const RemeshSettings& settings = input.settings;
  const std::uint64_t growth = settings.resizes() ? 4 : 1;
  const std::uint64_t edges = 3 * input.mesh.polygons.size() / 2 * growth;
  return 20'000 + settings.outer * edges * (1200 + 200ULL * settings.smoothing);
}

class RemeshCases {
 public:
  explicit RemeshCases(CaseMaker& maker) : maker_(maker) {}

  void add(const std::string& group, const RemeshInput& input) {
    maker_.add(group, title(input), remesh_budget(input), in_order(input), {kFunction});
  }

  void add_fresh(const std::string& group, const RemeshInput& input) {
    maker_.add_fresh(group, title(input) + ", before anything else", remesh_budget(input),
                     in_order(input), {kFunction});
  }

 private:
  static constexpr const char* kFunction = "PolyMesh::isotropicRemesh";

  static RemeshInput in_order(RemeshInput input) {
    input.mesh = in_build_order(input.mesh);
    return input;
  }

  static std::string title(const RemeshInput& input) {
    const char* const anchors[] = {"", ", each halfedge() the next one",
                                   ", each halfedge() the one after next"};
    return "remesh " + input.mesh_name + ": " + settings_text(input.settings) +
           anchors[input.anchor_turns % 3];
  }

  CaseMaker& maker_;
};

RemeshSettings smoothing(std::uint32_t iterations, double step, std::uint32_t outer = 1) {
  RemeshSettings settings;
  settings.outer = outer;
  settings.smoothing = iterations;
  settings.step = step;
  return settings;
}

RemeshSettings flips_only(std::uint32_t rounds) {
  RemeshSettings settings;
  settings.outer = rounds;
  return settings;
}

/// What a program would be called with.
RemeshSettings usual(std::uint32_t rounds) {
  RemeshSettings settings;
  settings.outer = rounds;
  settings.longer = 1.2;
  settings.shorter = 0.8;
  settings.smoothing = 10;
  return settings;
}

/// Closed meshes with at most six edges at each vertex: no flip pays.
void add_smoothing(RemeshCases& cases, const CaseMaker& maker) {
  Random random = maker.random("smoothing");
  for (const char* file : {"tetrahedron.obj", "octahedron.off", "icosahedron.obj"}) {
    const PolygonMesh mesh = shaken(maker.mesh(file), random);
    const std::string name = std::string(file) + ", shaken";
    cases.add("smoothing", {name, mesh, 0, smoothing(1, 0.25)});
    cases.add("smoothing", {name, mesh, 0, smoothing(3, 0.5)});
  }
  const PolygonMesh torus = shaken(torus_mesh(6, 5), random);
  cases.add("smoothing", {"a torus of 60 triangles, shaken", torus, 0, smoothing(1, 1.0)});
  cases.add("smoothing", {"a torus of 60 triangles, shaken", torus, 0, smoothing(10, 0.2)});
  cases.add("smoothing", {"a torus of 60 triangles, shaken", torus, 0, smoothing(2, 0.3, 3)});
}

void add_flips(RemeshCases& cases, const CaseMaker& maker) {
  Random random = maker.random("flips");
  for (const std::uint32_t n : {4U, 8U, 12U}) {
    const std::string name = "a torus with " + plural(n / 4 * (n / 4), "flipped edge");
    cases.add("flips", {name, torus_with_flips(n), 0, flips_only(1)});
  }
  for (const char* file : {"valence_zoo.obj", "double_torus.obj", "cube_crossed.obj"})
    cases.add("flips", {file, maker.mesh(file), 0, flips_only(1)});
  for (const std::uint32_t n : {8U, 13U, 24U}) {
    const std::string name = "a double pyramid with " + std::to_string(n) + " sides";
    cases.add("flips", {name, bipyramid(n), 0, flips_only(1)});
    cases.add("flips", {name, bipyramid(n), 0, flips_only(60)});
  }
  cases.add("flips", {"valence_zoo.obj", maker.mesh("valence_zoo.obj"), 0, flips_only(60)});
  cases.add("flips", {"a torus with 4 flipped edges, shaken",
                      shaken(torus_with_flips(8), random), 0, smoothing(2, 0.4)});
}

void add_lengths(RemeshCases& cases, const CaseMaker& maker) {
  Random random = maker.random("lengths");
  const std::pair<const char*, PolygonMesh> meshes[] = {
      {"octahedron.off, shaken", maker.mesh("octahedron.off")},
      {"icosahedron.obj, shaken", maker.mesh("icosahedron.obj")},
      {"a torus of 96 triangles, shaken", torus_mesh(8, 6)},
      {"a torus of 240 triangles, shaken", torus_mesh(12, 10)}};
  for (const WantedEdges wanted :
       {WantedEdges{true, false}, WantedEdges{false, true}, WantedEdges{true, true}}) {
    for (const auto& [name, mesh] : meshes) {
      const SureMesh sure = sure_mesh(mesh, wanted, random);
      cases.add("lengths", {name, sure.mesh, 0, sure.settings});
    }
  }
}

void add_whole(RemeshCases& cases, const CaseMaker& maker) {
  Random random = maker.random("whole");
  const PolygonMesh torus = crowded_torus(20, 12, random);
  for (const std::uint32_t rounds : {1U, 3U})
    cases.add("whole", {"a crowded torus of 480 triangles", torus, 0, usual(rounds), 1});
  RemeshSettings other = usual(4);
  other.longer = 4.0 / 3.0;
  other.shorter = 4.0 / 5.0;
  other.smoothing = 5;
  const PolygonMesh small = crowded_torus(16, 12, random);
  cases.add("whole", {"a crowded torus of 384 triangles", small, 1, other, 1});
  const PolygonMesh two = side_by_side(torus, mapped(small, [](const Point3& p) {
                                         return Point3{p[0] + 8.0, p[1], p[2]};
                                       }));
  cases.add("whole", {"two crowded tori", two, 2, usual(3), 1});
  for (const char* file : {"double_torus.obj", "valence_zoo.obj"})
    cases.add("whole", {file, maker.mesh(file), 0, usual(2)});
}

void add_boundaries(RemeshCases& cases, const CaseMaker& maker) {
  Random random = maker.random("boundaries");
  RemeshSettings refused = flips_only(1);
  refused.shorter = 0.9;
  for (const std::uint32_t n : {5U, 12U}) {
    cases.add("boundary", {"a narrow band of " + std::to_string(2 * n) + " triangles",
                           narrow_band(n), n % 2, refused});
  }
  const PolygonMesh grid = open_grid(6, random);
  cases.add("boundary", {"a square of 72 triangles", grid, 0, smoothing(1, 0.5)});
  cases.add("boundary", {"a square of 72 triangles", grid, 1, flips_only(2)});
  const SureMesh sure = sure_mesh(open_grid(6, random), {true, false}, random);
  cases.add("boundary", {"a square of 72 triangles", sure.mesh, 2, sure.settings});
  for (const char* file :
       {"single_triangle.obj", "two_triangles.obj", "fan.obj", "umbrella.obj", "grid_4x4.obj"})
    cases.add("boundary", {file, maker.mesh(file), 0, usual(2)});
}

/// What must not depend on anchors, size, place and direction.
void add_stress(RemeshCases& cases, const CaseMaker& maker) {
  Random random = maker.random("stress");
  const PolygonMesh icosahedron = maker.mesh("icosahedron.obj");
  cases.add("stress", {"icosahedron.obj", icosahedron, 1, flips_only(0)});
  const PolygonMesh torus = torus_mesh(8, 8);
  cases.add("stress", {"a torus with six edges at each vertex", torus, 1, flips_only(3)});
  const auto [both, factors] =
      sure_mesh(side_by_side(maker.mesh("octahedron.off"), maker.mesh("icosahedron.obj")),
                {true, true}, random);
  std::uint32_t turns = 0;
  for (const MovedMesh& moved : moved_meshes(both, {0, 1})) {
    const std::string name = "octahedron.off and icosahedron.obj, shaken, " + moved.how;
    cases.add("stress", {name, moved.mesh, turns % 3, factors});
    cases.add("stress", {name, moved.mesh, (turns++ + 1) % 3, smoothing(3, 0.3, 2)});
  }
  SureMesh round = sure_mesh(maker.mesh("octahedron.off"), {true, true}, random);
  round.settings.smoothing = 2;
  cases.add_fresh("stress", {"octahedron.off, shaken", round.mesh, 2, round.settings});
  cases.add_fresh("stress", {"a torus with 9 flipped edges", torus_with_flips(12), 1,
                             smoothing(1, 0.5, 2)});
  cases.add("stress", {"a torus of 5000 triangles", torus_mesh(50, 50), 0, smoothing(2, 0.5)});
  // So many flips may leave vertices with two edges, which have no normal.
  RemeshSettings unsmoothed = usual(1);
  unsmoothed.smoothing = 0;
  const PolygonMesh large = crowded_torus(80, 32, random);
  cases.add("stress", {"a crowded torus of 5120 triangles", large, 1, unsmoothed});
}

}  // namespace

void make_isotropic_remeshing_cases(CaseMaker& maker) {
  RemeshCases cases(maker);
  add_flips(cases, maker);
  add_lengths(cases, maker);
  add_smoothing(cases, maker);
  add_whole(cases, maker);
  add_boundaries(cases, maker);
  add_stress(cases, maker);
}

void shrink_isotropic_remeshing_case(CaseMaker& maker, const Case& failed) {
  RemeshCases cases(maker);
  const auto input = from_wire<RemeshInput>(failed.input);
  const auto add_with = [&](auto change) {
    RemeshInput smaller = input;
    change(smaller.settings);
    cases.add(failed.group, smaller);
  };
  if (input.settings.outer > 1) add_with([](RemeshSettings& settings) { settings.outer = 1; });
  if (input.settings.smoothing > 1)
    add_with([](RemeshSettings& settings) { settings.smoothing = 1; });
  // What the limits are good for is known of this mesh only.
  if (input.settings.resizes() || input.improves != 0) return;
  for (const Rung& rung : smaller_meshes_alike(maker, input.mesh))
    cases.add(failed.group, {rung.file, rung.mesh, input.anchor_turns, input.settings});
}

}  // namespace meshgrade
