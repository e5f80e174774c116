#pragma once

// What a right solution leaves behind for a case, made without any half-edge code of a student
// or of the reference: from closed forms, OpenSubdiv, and the models of flip and split.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

#include "grader/base/wire.h"
#include "grader/cases/bezier_input.h"
#include "grader/cases/case.h"
#include "grader/cases/local_operation_input.h"
#include "grader/cases/mesh_input.h"
#include "grader/cases/placement_cases.h"
#include "grader/cases/remesh_input.h"
#include "grader/cases/simplification_input.h"
#include "grader/cases/whole_mesh_input.h"
#include "grader/judge/bezier_forms.h"
#include "grader/judge/collapse_search.h"
#include "grader/judge/operation_model.h"
#include "grader/judge/operations_judge.h"
#include "grader/judge/refinement_rules.h"
#include "grader/judge/remesh_smoothing.h"
#include "grader/operations/local_operation_list.h"
#include "grader/operations/picked_element.h"
#include "grader/operations/remesh_steps.h"
#include "grader/run/outcome.h"
#include "grader/simplify/openmesh_decimation.h"
#include "grader/subdivide/opensubdiv_level.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {

inline Ref find_edge(const MeshDump& mesh, Ref a, Ref b) {
  for (Ref e = 0; e < mesh.edges.size(); ++e) {
    const HalfedgeRecord& h = mesh.halfedges[mesh.edges[e].halfedge];
    const Ref end = mesh.halfedges[h.twin].vertex;
    if (std::minmax(h.vertex, end) == std::minmax(a, b)) return e;
  }
  return kUnsetRef;
}

inline std::vector<std::string> right_operations(const OperationsInput& input) {
  std::vector<std::string> steps;
  MeshDump mesh = first_mesh(input);
  for (const Operation& operation : input.operations) {
    OperationStep step;
    step.edge = find_edge(mesh, operation.a, operation.b);
    if (input.anchoring == Anchoring::kOnEachEdge)
      model_anchor_on(mesh, step.edge, operation.anchors);
    step.returned = step.edge;
    if (operation.kind == OperationKind::kSplit) {
      step.returned = model_split(mesh, step.edge);
    } else if (!is_boundary_edge(mesh, step.edge)) {
      const Diamond d = diamond_of(mesh, step.edge);
      if (find_edge(mesh, d.a, d.d) == kUnsetRef) model_flip(mesh, step.edge);
    }
    step.after = mesh;
    steps.push_back(to_wire(step));
  }
  return steps;
}

inline std::vector<std::string> right_levels(const SubdivisionInput& input, VertexRule rule,
                                             CornerRule corner) {
  std::vector<std::string> steps;
  PolygonMesh mesh = input.mesh;
  for (std::uint32_t level = 0; level < input.levels; ++level) {
    mesh = opensubdiv_loop(mesh, rule, corner).mesh;
    steps.push_back(to_wire(dump_polygons(mesh)));
  }
  return steps;
}

inline Point3 face_vector(const PolygonMesh& mesh, const std::vector<std::uint32_t>& t) {
  const Point3& p = mesh.positions[t[0]];
  const Point3& q = mesh.positions[t[1]];
  const Point3& r = mesh.positions[t[2]];
  const Point3 a{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  const Point3 b{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double corner_angle(const PolygonMesh& mesh, const std::vector<std::uint32_t>& t,
                           std::size_t corner) {
  const Point3& p = mesh.positions[t[corner]];
  const Point3& q = mesh.positions[t[(corner + 1) % 3]];
  const Point3& r = mesh.positions[t[(corner + 2) % 3]];
  double dot = 0.0;
  double qq = 0.0;
  double rr = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    dot += (q[i] - p[i]) * (r[i] - p[i]);
    qq += (q[i] - p[i]) * (q[i] - p[i]);
    rr += (r[i] - p[i]) * (r[i] - p[i]);
  }
  return std::acos(std::clamp(dot / std::sqrt(qq * rr), -1.0, 1.0));
}

enum class NormalWeights { kArea, kEqual, kAngle };

/// Vertex normals as sums over faces with one of the usual weights.
inline std::vector<Point3> vertex_normals(const PolygonMesh& mesh, NormalWeights weights) {
  std::vector<Point3> sums(mesh.positions.size(), Point3{});
  for (const auto& t : mesh.polygons) {
    const Point3 area = face_vector(mesh, t);
    const double twice_area = std::hypot(area[0], area[1], area[2]);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const double weight = weights == NormalWeights::kArea ? 1.0
                            : weights == NormalWeights::kEqual
                                ? 1.0 / twice_area
                                : corner_angle(mesh, t, corner) / twice_area;
      for (std::size_t i = 0; i < 3; ++i)
        sums[t[corner]][i] += weight * area[i];
    }
  }
  for (Point3& sum : sums) {
    const double norm = std::hypot(sum[0], sum[1], sum[2]);
    for (double& x : sum)
      x /= norm;
  }
  return sums;
}

inline std::vector<std::string> right_curve(const CurveInput& input) {
  std::vector<std::string> steps;
  std::vector<Point2> points = input.points;
  for (std::uint32_t i = 0; i < input.steps; ++i) {
    CurveStep step{de_casteljau_step(points, input.t), points};
    points = step.result;
    steps.push_back(to_wire(step));
  }
  return steps;
}

inline Point3 de_casteljau(std::vector<Point3> points, double t) {
  while (points.size() > 1)
    points = de_casteljau_step(points, t);
  return points.at(0);
}

inline std::vector<std::string> right_patch(const PatchInput& input) {
  std::vector<std::string> steps;
  for (const auto& [u, v] : input.parameters) {
    std::vector<Point3> result;
    if (input.function == PatchFunction::kStep) {
      result = de_casteljau_step(input.net[0], u);
    } else if (input.function == PatchFunction::kLine) {
      result = {de_casteljau(input.net[0], u)};
    } else {
      std::vector<Point3> column;
      for (const auto& row : input.net)
        column.push_back(de_casteljau(row, u));
      result = {de_casteljau(column, v)};
    }
    steps.push_back(to_wire(result));
  }
  return steps;
}

inline Ref find_by_corners(const MeshDump& mesh, ElementKind kind, const Corners& corners) {
  for (std::uint32_t place = 0; place < count_elements(mesh, kind); ++place) {
    const Ref element = find_element(mesh, kind, place);
    const Corners its = corners_of(mesh, kind, element).corners;
    const bool same = kind == ElementKind::kEdge
                          ? std::is_permutation(its.begin(), its.end(), corners.begin())
                          : canonical(its) == canonical(corners);
    if (same) return element;
  }
  for (Ref loop = 0; loop < mesh.boundaries.size() && kind == ElementKind::kFace; ++loop) {
    if (canonical(corners_of(mesh, kind, loop | kBoundaryBit).corners) == canonical(corners))
      return loop | kBoundaryBit;
  }
  return kUnsetRef;
}

/// Refuses whatever may be refused.
inline std::vector<std::string> right_local_operations(const LocalOperationInput& input,
                                                       const LocalOperation& operation) {
  std::vector<std::string> steps;
  MeshDump mesh = built_mesh(input.mesh, input.anchor_turns);
  for (std::size_t i = 0; i < input.places.size(); i += operation.picks_two ? 2 : 1) {
    LocalStep step;
    step.picked = find_element(mesh, operation.picks, input.places[i]);
    Picked picked = corners_of(mesh, operation.picks, step.picked);
    if (operation.picks_two) {
      step.partner = find_element(mesh, operation.picks, input.places[i + 1]);
      picked.partner = corners_of(mesh, operation.picks, step.partner).corners;
    }
    const Answer answer = operation.answer(face_lists_of(mesh), picked);
    step.refused = answer.demand == Demand::kMust ? 0 : 1;
    if (step.refused == 0) {
      mesh = mesh_of(answer.after);
      step.returned = find_by_corners(mesh, operation.returns, answer.returned.at(0));
    }
    if (!answer.anchored_to.empty()) {
      for (Ref h = 0; h < mesh.halfedges.size(); ++h) {
        if (mesh.halfedges[h].vertex == step.returned &&
            mesh.halfedges[mesh.halfedges[h].twin].vertex == answer.anchored_to[0])
          mesh.vertices[step.returned].halfedge = h;
      }
    }
    step.after = mesh;
    steps.push_back(to_wire(step));
  }
  return steps;
}

using LabelPair = std::pair<Label, Label>;

inline LabelPair sorted_pair(Label a, Label b) {
  return std::minmax(a, b);
}

/// Cuts a face from the first of its corners from where no cut gets the ends of an edge.
/// @param edges  all that there are; the cuts are added
inline std::vector<Corners> cut_into_triangles(const Corners& face,
                                               std::set<LabelPair>& edges) {
  for (const Label apex : face) {
    const Corners corners = beginning_with(face, apex);
    std::vector<Corners> triangles;
    std::set<LabelPair> cuts;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      triangles.push_back({apex, corners[i], corners[i + 1]});
      if (i > 1) cuts.insert(sorted_pair(apex, corners[i]));
    }
    const bool is_free = std::none_of(
        cuts.begin(), cuts.end(), [&](const LabelPair& cut) { return edges.count(cut) != 0; });
    if (!is_free) continue;
    edges.insert(cuts.begin(), cuts.end());
    return triangles;
  }
  throw std::logic_error("no corner to cut from");
}

inline FaceLists cut_into_triangles(FaceLists lists) {
  std::set<LabelPair> edges;
  for (const Corners& face : lists.faces) {
    for (std::size_t i = 0; i < face.size(); ++i)
      edges.insert(sorted_pair(face[i], face[(i + 1) % face.size()]));
  }
  std::vector<Corners> triangles;
  for (const Corners& face : lists.faces) {
    for (Corners& triangle : cut_into_triangles(face, edges))
      triangles.push_back(std::move(triangle));
  }
  lists.faces = std::move(triangles);
  return lists;
}

/// The same mesh whose edges have the numbers that they have in another one, new ones behind.
inline MeshDump with_edges_of(const MeshDump& old, MeshDump mesh) {
  std::map<LabelPair, Ref> known;
  for (Ref e = 0; e < old.edges.size(); ++e) {
    const HalfedgeRecord& h = old.halfedges[old.edges[e].halfedge];
    known[sorted_pair(h.vertex, old.halfedges[h.twin].vertex)] = e;
  }
  std::vector<Ref> number(mesh.edges.size());
  auto next = static_cast<Ref>(old.edges.size());
  for (Ref e = 0; e < mesh.edges.size(); ++e) {
    const HalfedgeRecord& h = mesh.halfedges[mesh.edges[e].halfedge];
    const auto same = known.find(sorted_pair(h.vertex, mesh.halfedges[h.twin].vertex));
    number[e] = same != known.end() ? same->second : next++;
  }
  const std::vector<EdgeRecord> edges = mesh.edges;
  for (Ref e = 0; e < edges.size(); ++e)
    mesh.edges[number[e]] = edges[e];
  for (HalfedgeRecord& h : mesh.halfedges)
    h.edge = number[h.edge];
  return mesh;
}

inline std::vector<std::string> right_triangulations(const WholeMeshInput& input) {
  const MeshDump built = built_mesh(input.mesh, input.anchor_turns);
  const MeshDump cut = with_edges_of(built, mesh_of(cut_into_triangles(face_lists_of(built))));
  return std::vector<std::string>(input.times, to_wire(cut));
}

/// By the closed forms, which know nothing of OpenSubdiv.
inline std::vector<std::string> right_refinements(const WholeMeshInput& input,
                                                  RefinementScheme scheme) {
  std::vector<std::string> steps;
  PolygonMesh polygons = input.mesh;
  for (std::uint32_t level = 0; level < input.times; ++level) {
    RefinementStep step;
    step.after = built_mesh(polygons, input.anchor_turns);
    const SurfaceRings rings = rings_of(step.after);
    RefinedPoints points;
    const RefinementRules rules(rings, scheme, points);
    points.faces = rules.points(PointKind::kFace);
    points.edges = rules.points(PointKind::kEdge);
    points.vertices = rules.points(PointKind::kVertex);
    const auto place = [](const std::vector<Point3>& from, std::vector<PlacedElement>& to) {
      for (Ref i = 0; i < from.size(); ++i)
        to.push_back({i, from[i]});
    };
    place(points.vertices, step.vertices);
    place(points.edges, step.edges);
    place(points.faces, step.faces);
    polygons = refined_mesh(step.after, points);
    steps.push_back(to_wire(step));
  }
  return steps;
}

/// Refuses what it must, and takes the vertices by OpenSubdiv otherwise.
inline std::vector<std::string> right_loop_refinements(const WholeMeshInput& input,
                                                       VertexRule rule, CornerRule corner) {
  std::vector<std::string> steps;
  if (!is_triangle_mesh(input.mesh))
    return {to_wire(RefusableStep{0, built_mesh(input.mesh, input.anchor_turns)})};
  const SubdivisionInput levels{input.mesh_name, input.mesh, input.times};
  for (const std::string& level : right_levels(levels, rule, corner))
    steps.push_back(to_wire(RefusableStep{1, from_wire<MeshDump>(level)}));
  return steps;
}

/// By the cheapest collapses on lists; larger meshes by OpenMesh, which is free to choose
/// there.
inline std::vector<std::string> right_simplifications(const SimplificationInput& input) {
  const MeshDump built = built_mesh(input.mesh, input.anchor_turns);
  const auto goal = static_cast<std::size_t>(
      std::floor(input.ratio * static_cast<double>(input.mesh.polygons.size())));
  if (input.ratio >= 1.0) return {to_wire(RefusableStep{1, built})};
  if (input.mesh.polygons.size() > 300) {
    const PolygonMesh made = openmesh_decimation(input.mesh, goal);
    return {to_wire(RefusableStep{1, dump_polygons(made)})};
  }
  FaceLists lists = face_lists_of(built);
  // Each takes two faces at most.
  for (std::size_t n = (lists.faces.size() - goal + 1) / 2; lists.faces.size() > goal; ++n) {
    const CollapsePath path =
        cheapest_collapses(face_lists_of(built), right_collapse_ways()[0], n);
    lists = path.left.lists();
    if (path.done.size() < n) break;
  }
  return {to_wire(RefusableStep{lists.faces.size() <= goal ? 1U : 0U, mesh_of(lists)})};
}

inline std::vector<std::string> right_placements(const PlacementInput& input, bool bevel) {
  std::vector<std::string> steps;
  const std::vector<RingCorner> ring = ring_of(input.mesh, input.face);
  Point3 mean{};
  for (const RingCorner& corner : ring) {
    for (std::size_t k = 0; k < 3; ++k)
      mean[k] += input.mesh.positions[corner.outer][k] / static_cast<double>(ring.size());
  }
  for (const Placement& call : input.calls) {
    MeshDump mesh = built_mesh(input.mesh, input.anchor_turns);
    for (const RingCorner& corner : ring) {
      const Point3& at = input.mesh.positions[corner.corner];
      const Point3& outer = input.mesh.positions[corner.outer];
      Point3 way{outer[0] - at[0], outer[1] - at[1], outer[2] - at[2]};
      const double along =
          way[0] * call.vector[0] + way[1] * call.vector[1] + way[2] * call.vector[2];
      for (std::size_t k = 0; k < 3; ++k)
        mesh.vertices[corner.corner].position[k] =
            bevel ? at[k] + call.amount / along * way[k]
                  : outer[k] + call.amount * (mean[k] - outer[k]) + call.vector[k];
    }
    steps.push_back(to_wire(mesh));
  }
  return steps;
}

/// Splits, then collapses, by lists of faces: what may be refused is.
inline void resize_edges(FaceLists& lists, double longest, double shortest) {
  const auto answer_of = [&](const char* operation, const EdgeEnds& edge) {
    return find_local_operation(operation)->answer(lists, {{edge.first, edge.second}});
  };
  for (const EdgeEnds& edge : edges_of(lists)) {
    if (edge_length(lists, edge) > longest) lists = answer_of("edge_split_polygon", edge).after;
  }
  for (const EdgeEnds& edge : edges_of(lists)) {
    if (edge_length(lists, edge) >= shortest) continue;
    if (!Surface(lists).is_edge(edge.first, edge.second)) continue;
    const Answer answer = answer_of("edge_collapse", edge);
    if (answer.demand == Demand::kMust) lists = answer.after;
  }
}

inline void flip_edges(FaceLists& lists) {
  Surface surface(lists);
  for (const EdgeEnds& edge : edges_of(lists)) {
    const auto place = flip_place(surface, lists, edge);
    if (!place || flip_gain(surface, *place) <= 0) continue;
    if (surface.is_edge(place->c, place->d)) continue;
    flip(lists, *place);
    surface = Surface(lists);
  }
}

inline void smooth_vertices(FaceLists& lists, const RemeshSettings& settings) {
  const MeshDump mesh = mesh_of(lists);
  std::vector<Label> same(mesh.vertices.size());
  std::iota(same.begin(), same.end(), 0U);
  lists.positions = smoothed(triangle_rings(mesh, same, same.size()), lists.positions,
                             settings.step, settings.smoothing, NormalWeight::kArea);
}

inline MeshDump right_remeshing(const RemeshInput& input) {
  const MeshDump built = built_mesh(input.mesh, input.anchor_turns);
  const RemeshSettings& settings = input.settings;
  // Of a mesh that large it is only asked that it stays one.
  const bool is_large = settings.resizes() && input.mesh.polygons.size() > 2000;
  if (settings.outer == 0 || is_large) return built;
  FaceLists lists = face_lists_of(built);
  for (std::uint32_t round = 0; round < settings.outer; ++round) {
    const double mean = mean_edge_length(lists);
    if (settings.resizes())
      resize_edges(lists, settings.longer * mean, settings.shorter * mean);
    flip_edges(lists);
    if (settings.smoothing > 0) smooth_vertices(lists, settings);
  }
  return mesh_of(lists);
}

inline Outcome right_outcome(const Case& c, VertexRule rule = VertexRule::kWarren,
                             CornerRule corner = CornerRule::kSmooth) {
  Outcome outcome;
  if (c.exercise == "bezier_curve") outcome.steps = right_curve(from_wire<CurveInput>(c.input));
  if (c.exercise == "bezier_patch") outcome.steps = right_patch(from_wire<PatchInput>(c.input));
  if (c.exercise == "vertex_normal") {
    for (const Point3& n :
         vertex_normals(from_wire<NormalInput>(c.input).mesh, NormalWeights::kArea))
      outcome.steps.push_back(to_wire(n));
  }
  if (c.exercise == "edge_flip" || c.exercise == "edge_split")
    outcome.steps = right_operations(from_wire<OperationsInput>(c.input));
  if (const LocalOperation* operation = find_local_operation(c.exercise))
    outcome.steps = right_local_operations(from_wire<LocalOperationInput>(c.input), *operation);
  if (c.exercise == "extrude_positions" || c.exercise == "bevel_positions")
    outcome.steps =
        right_placements(from_wire<PlacementInput>(c.input), c.exercise == "bevel_positions");
  if (c.exercise == "triangulation")
    outcome.steps = right_triangulations(from_wire<WholeMeshInput>(c.input));
  if (c.exercise == "linear_subdivision")
    outcome.steps =
        right_refinements(from_wire<WholeMeshInput>(c.input), RefinementScheme::kLinear);
  if (c.exercise == "catmull_clark")
    outcome.steps =
        right_refinements(from_wire<WholeMeshInput>(c.input), RefinementScheme::kCatmullClark);
  if (c.exercise == "loop_refinement")
    outcome.steps = right_loop_refinements(from_wire<WholeMeshInput>(c.input), rule, corner);
  if (c.exercise == "isotropic_remeshing")
    outcome.steps = {to_wire(right_remeshing(from_wire<RemeshInput>(c.input)))};
  if (c.exercise == "simplification")
    outcome.steps = right_simplifications(from_wire<SimplificationInput>(c.input));
  if (c.exercise == "loop_subdivision")
    outcome.steps = right_levels(from_wire<SubdivisionInput>(c.input), rule, corner);
  return outcome;
}

}  // namespace meshgrade
