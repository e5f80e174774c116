#include <map>

#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

/// From each corner of the faces at v to the next one: what is left of their sides without v.
std::map<Label, Label> outline(const FaceLists& before, const Surface& surface, Label v,
                               bool& simple) {
  std::map<Label, Label> next;
  simple = true;
  for (std::size_t f : surface.faces_at(v)) {
    const Corners turned = beginning_with(before.faces[f], v);
    for (std::size_t i = 1; i + 1 < turned.size(); ++i)
      simple = next.emplace(turned[i], turned[i + 1]).second && simple;
  }
  return next;
}

/// The corner that no other leads to: where the outline begins at a boundary. Any inside.
Label first_of(const std::map<Label, Label>& next) {
  std::map<Label, bool> led_to;
  for (const auto& step : next)
    led_to[step.second] = true;
  for (const auto& step : next) {
    if (!led_to[step.first]) return step.first;
  }
  return next.begin()->first;
}

/// @return the corners in order; fewer than there are, or more, if they are no single chain
Corners chain_of(const std::map<Label, Label>& next) {
  Corners corners{first_of(next)};
  for (auto step = next.find(corners[0]); step != next.end();
       step = next.find(corners.back())) {
    if (step->second == corners[0] || corners.size() > next.size()) break;
    corners.push_back(step->second);
  }
  return corners;
}

Answer vertex_dissolve_answer(const FaceLists& before, const Picked& picked) {
  const Label v = picked.corners[0];
  const Surface surface(before);
  bool simple = true;
  const std::map<Label, Label> next = outline(before, surface, v, simple);
  const Corners face = chain_of(next);
  const bool boundary = surface.is_boundary(v);
  const std::size_t expected = next.size() + (boundary ? 1 : 0);
  if (!simple || face.size() != expected)
    return refuse(before, "the faces around it share more than it and an edge at it");
  if (face.size() < 3) return refuse(before, "the face that is left would have two corners");
  Answer answer;
  answer.after.positions = before.positions;
  for (const Corners& corners : before.faces) {
    if (!place_of(corners, v)) answer.after.faces.push_back(corners);
  }
  answer.after.faces.push_back(face);
  answer.first_free = static_cast<Label>(before.positions.size());
  answer.returned = {face};
  if (boundary && surface.loop_of(v, face.back()).size() == 3)
    return refuse(before, "its boundary has three edges and would have two");
  if (boundary && surface.neighbours(v).size() == 2)
    return allow(std::move(answer), "it is the corner of one face only");
  return settle(std::move(answer));
}

}  // namespace

LocalOperation vertex_dissolve_operation() {
  return {"vertex_dissolve",
          "PolyMesh::dissolveVertex",
          "dissolve",
          ElementKind::kVertex,
          ElementKind::kFace,
          vertex_dissolve_answer,
          "the vertex and all edges at it go; a boundary gets one new edge"};
}

}  // namespace meshgrade
