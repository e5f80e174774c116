#include "grader/cases/local_operation_cases.h"

#include <algorithm>

#include "grader/base/text.h"
#include "grader/cases/local_operation_input.h"
#include "grader/cases/moved_meshes.h"
#include "grader/operations/picked_element.h"

namespace meshgrade {
namespace {

/// Handle uses that a good solution never needs for one operation on a small mesh.
constexpr std::uint64_t kBudget = 20'000;

std::string anchors_text(std::uint32_t turns) {
  if (turns == 0) return {};
  return turns == 1 ? ", each halfedge() the next one" : ", each halfedge() the one after next";
}

const std::vector<std::string>& closed_meshes() {
  static const std::vector<std::string> files{
      "quad_cube.dae",    "prism_5.obj",    "pyramid_4.obj",
      "dodecahedron.obj", "octahedron.off", "quad_torus.obj",
      "bipyramid_3.obj",  "pouch.obj",      "lens.obj"};
  return files;
}

const std::vector<std::string>& open_meshes() {
  static const std::vector<std::string> files{
      "mixed_strip.obj",     "quad_grid_3x3.obj", "tube_6.obj",      "ring_5.obj", "fan.obj",
      "single_triangle.obj", "single_quad.obj",   "two_patches.obj", "octagon.obj"};
  return files;
}

/// The elements that an operation can be asked about: the places of one, or of two.
using Places = std::vector<std::uint32_t>;

/// Each element; of operations that pick two, each pair of those at a boundary, in one of its
/// two orders, and some other pairs.
std::vector<Places> all_places(const LocalOperation& operation, const MeshDump& built) {
  const Surface surface(face_lists_of(built));
  const std::uint32_t n = count_elements(built, operation.picks);
  std::vector<Places> all;
  std::vector<std::uint32_t> at_boundary;
  for (std::uint32_t place = 0; place < n; ++place) {
    if (!operation.picks_two) {
      all.push_back({place});
      continue;
    }
    const Corners corners = pick(built, operation.picks, place).corners;
    if (!surface.is_boundary_edge(corners[0], corners[1])) {
      all.push_back({place, (place + 1) % n});
      continue;
    }
    all.push_back({place, place});
    for (std::uint32_t other : at_boundary)
      all.push_back((place + other) % 2 == 0 ? Places{place, other} : Places{other, place});
    at_boundary.push_back(place);
  }
  return all;
}

/// What these places ask for.
Picked pick_all(const LocalOperation& operation, const MeshDump& built, const Places& places) {
  Picked picked = pick(built, operation.picks, places[0]);
  if (operation.picks_two) picked.partner = pick(built, operation.picks, places[1]).corners;
  return picked;
}

/// Whether an element touches a boundary.
bool touches_boundary(const Surface& surface, const Picked& picked) {
  return std::any_of(picked.corners.begin(), picked.corners.end(),
                     [&](Label corner) { return surface.is_boundary(corner); });
}

const char* group_of(const Answer& answer, bool at_boundary) {
  if (answer.demand != Demand::kMust) return "refused";
  return at_boundary ? "boundary" : "basic";
}

PolygonMesh copies_apart(const PolygonMesh& mesh, std::size_t n) {
  PolygonMesh all = mesh;
  for (std::size_t i = 1; i < n; ++i)
    all = side_by_side(mesh, all);
  return all;
}

class OperationCases {
 public:
  OperationCases(CaseMaker& maker, const LocalOperation& operation)
      : maker_(maker), operation_(operation) {}

  /// A case for each element of a mesh, in the group that its answer says; in `stress`, if the
  /// anchors are others.
  void add_every_element(const std::string& file, std::uint32_t anchor_turns) {
    const PolygonMesh mesh = maker_.mesh(file);
    const MeshDump built = built_mesh(mesh);
    const FaceLists lists = face_lists_of(built);
    const Surface surface(lists);
    for (const Places& places : all_places(operation_, built)) {
      const Picked picked = pick_all(operation_, built, places);
      const Answer answer = operation_.answer(lists, picked);
      const char* group =
          anchor_turns != 0 ? "stress" : group_of(answer, touches_boundary(surface, picked));
      add(group, title(picked, file) + anchors_text(anchor_turns),
          {file, mesh, anchor_turns, places}, kBudget);
    }
  }

  /// Operations one after the other, on elements that are drawn.
  void add_sequence(const std::string& name, const PolygonMesh& mesh, Random& random) {
    add("stress", sequence_title(name), drawn(name, mesh, random), kLength * kBudget);
  }

  /// The same with other anchors, in a process in which nothing was called before: a function
  /// may be wrong at its third call only.
  void add_fresh_sequence(const std::string& name, const PolygonMesh& mesh, Random& random,
                          std::uint32_t anchor_turns = 1) {
    LocalOperationInput input = drawn(name, mesh, random);
    input.anchor_turns = anchor_turns;
    maker_.add_fresh("stress", sequence_title(name) + ", before anything else",
                     kLength * kBudget, input, {operation_.function});
  }

  /// What must be refused, four times: each time the mesh is the same.
  void add_refused_again(const std::string& file) {
    const PolygonMesh mesh = maker_.mesh(file);
    const MeshDump built = built_mesh(mesh);
    for (const Places& places : all_places(operation_, built)) {
      const Picked picked = pick_all(operation_, built, places);
      if (operation_.answer(face_lists_of(built), picked).demand != Demand::kRefuse) continue;
      Places four_times;
      for (int i = 0; i < 4; ++i)
        four_times.insert(four_times.end(), places.begin(), places.end());
      maker_.add_fresh("stress", title(picked, file) + ", four times, before anything else",
                       4 * kBudget, LocalOperationInput{file, mesh, 0, four_times},
                       {operation_.function});
    }
  }

  /// Two elements that share an end, in each of four equal parts of a mesh, in a process in
  /// which nothing was called before. The last part goes first: what comes before it keeps its
  /// place.
  void add_fresh_neighbours() {
    constexpr std::uint32_t kParts = 4;
    const PolygonMesh part = quad_grid(2, 1);
    const MeshDump built = built_mesh(part);
    const std::uint32_t in_a_part = count_elements(built, operation_.picks);
    for (const Places& places : all_places(operation_, built)) {
      const Picked picked = pick_all(operation_, built, places);
      const bool share = std::any_of(
          picked.corners.begin(), picked.corners.end(),
          [&](Label corner) { return place_of(picked.partner, corner).has_value(); });
      if (!share || operation_.answer(face_lists_of(built), picked).demand != Demand::kMust)
        continue;
      for (const std::uint32_t anchor_turns : {0U, 1U}) {
        LocalOperationInput input{
            "four strips of two quads", copies_apart(part, kParts), anchor_turns, {}};
        for (std::uint32_t i = kParts; i-- > 0;) {
          for (std::uint32_t place : places)
            input.places.push_back(i * in_a_part + place);
        }
        maker_.add_fresh("stress",
                         title(picked, "each of four strips of two quads") +
                             anchors_text(anchor_turns) + ", before anything else",
                         kParts * kBudget, input, {operation_.function});
      }
    }
  }

  /// Some of the elements at vertices with more than 12 edges, with both kinds of anchors.
  void add_high_valences(const std::string& name, const PolygonMesh& mesh) {
    const MeshDump built = built_mesh(mesh);
    const Surface surface(face_lists_of(built));
    std::vector<Places> high;
    for (Places& places : all_places(operation_, built)) {
      const Corners corners = pick_all(operation_, built, places).corners;
      if (std::any_of(corners.begin(), corners.end(),
                      [&](Label corner) { return surface.neighbours(corner).size() > 12; }))
        high.push_back(std::move(places));
    }
    constexpr std::size_t kMost = 12;
    const std::size_t step = std::max<std::size_t>(1, high.size() / kMost);
    for (std::size_t i = 0; i < high.size(); i += step) {
      const Picked picked = pick_all(operation_, built, high[i]);
      for (const std::uint32_t anchor_turns : {0U, 1U, 2U})
        add("stress", title(picked, name) + anchors_text(anchor_turns),
            {name, mesh, anchor_turns, high[i]}, kBudget);
    }
  }

  /// Far from the boundary of a large mesh, with less than the budget of a small one, and at
  /// its boundary, with all of it: to walk around a boundary loop is to walk around a face.
  void add_constant_work() {
    constexpr std::uint32_t kSide = 100;
    const PolygonMesh mesh = quad_grid(kSide, kSide);
    const MeshDump built = built_mesh(mesh);
    const std::uint32_t middle = count_elements(built, operation_.picks) / 2;
    // Of one kind of elements a row begins in the middle of the list, of another it does not.
    const Surface surface(face_lists_of(built));
    const Picked in_a_row = pick(built, operation_.picks, middle + kSide / 2);
    const std::uint32_t inside =
        touches_boundary(surface, in_a_row) ? middle : middle + kSide / 2;
    for (const std::uint32_t place : {inside, 0U}) {
      Places places{place};
      if (operation_.picks_two) places.push_back(place + 2 * kSide);
      add("stress", title(pick_all(operation_, built, places), "a grid of 10,000 quads"),
          {"a grid of 10,000 quads", mesh, 0, places},
          place == inside ? kBudget / 10 : kBudget);
    }
  }

 private:
  static constexpr std::size_t kLength = 6;  ///< of sequences

  std::string sequence_title(const std::string& mesh) const {
    return operation_.verb + " " + std::to_string(kLength) + " elements of " + mesh +
           ", one after the other";
  }

  LocalOperationInput drawn(const std::string& name, const PolygonMesh& mesh,
                            Random& random) const {
    LocalOperationInput input{name, mesh, 0, {}};
    for (std::size_t i = 0; i < kLength * (operation_.picks_two ? 2 : 1); ++i)
      input.places.push_back(random.below(10'000));
    return input;
  }

  std::string title(const Picked& picked, const std::string& mesh) const {
    const std::string kind = kind_name(operation_.picks);
    if (operation_.picks_two)
      return operation_.verb + " the " + kind + "s " + corners_text(picked.corners) + " and " +
             corners_text(picked.partner) + " of " + mesh;
    return operation_.verb + " the " + kind + " " + corners_text(picked.corners) + " of " +
           mesh;
  }

  static std::string corners_text(const Corners& corners) {
    std::vector<std::string> names;
    for (Label corner : corners)
      names.push_back(vertex_name(corner));
    return join(names, "-");
  }

  void add(const std::string& group, const std::string& title, const LocalOperationInput& input,
           std::uint64_t budget) {
    maker_.add(group, title, budget, input, {operation_.function});
  }

  CaseMaker& maker_;
  const LocalOperation& operation_;
};

void add_sequences(OperationCases& cases, CaseMaker& maker, Random& random) {
  for (const char* file : {"dodecahedron.obj", "quad_torus.obj", "quad_grid_3x3.obj",
                           "mixed_strip.obj", "tube_6.obj", "icosahedron.obj"}) {
    cases.add_sequence(file, maker.mesh(file), random);
  }
  for (const char* file : {"prism_5.obj", "tube_6.obj", "mixed_strip.obj", "quad_torus.obj",
                           "quad_grid_3x3.obj", "dodecahedron.obj"}) {
    for (int i = 0; i < 4; ++i)
      cases.add_fresh_sequence(file, maker.mesh(file), random);
  }
  for (const char* file : {"dodecahedron.obj", "tube_6.obj", "mixed_strip.obj"}) {
    const PolygonMesh mesh = shaken(maker.mesh(file), random);
    for (const MovedMesh& moved : moved_meshes(mesh, {0, 1}))
      cases.add_sequence(file + std::string(", shaken, ") + moved.how, moved.mesh, random);
  }
  // The third call at a boundary, as build() leaves it.
  Random at_boundary = maker.random("sequences at a boundary");
  for (const char* file : {"single_quad.obj", "ring_5.obj"}) {
    for (int i = 0; i < 3; ++i)
      cases.add_fresh_sequence(file, maker.mesh(file), at_boundary, 0);
  }
  // Where hardly anything is refused of two elements, so that the third call does something.
  Random on_parts = maker.random("sequences on parts");
  for (const std::uint32_t anchor_turns : {0U, 1U, 0U, 1U})
    cases.add_fresh_sequence("eight quads apart",
                             copies_apart(maker.mesh("single_quad.obj"), 8), on_parts,
                             anchor_turns);
}

}  // namespace

void make_local_operation_cases(CaseMaker& maker, const LocalOperation& operation) {
  OperationCases cases(maker, operation);
  for (const auto* files : {&closed_meshes(), &open_meshes()}) {
    for (const std::string& file : *files)
      cases.add_every_element(file, 0);
  }
  for (const char* file : {"prism_5.obj", "mixed_strip.obj", "tube_6.obj"})
    for (const std::uint32_t anchor_turns : {1U, 2U})
      cases.add_every_element(file, anchor_turns);
  Random random = maker.random("sequences");
  add_sequences(cases, maker, random);
  if (operation.picks_two) cases.add_fresh_neighbours();
  for (const char* file : {"lens.obj", "pouch.obj", "ring_5.obj"})
    cases.add_refused_again(file);
  cases.add_high_valences("double pyramids with 13 to 24 sides", many_valences(13, 24, random));
  cases.add_high_valences("a fan of 22 triangles", open_fan(22));
  cases.add_constant_work();
}

}  // namespace meshgrade
