#include "grader/report/mesh_json.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

Json faces_value(const std::vector<FaceRecord>& faces) {
  Json list = Json::array();
  for (const FaceRecord& f : faces) {
    list.push_back(f.halfedge);
    list.push_back(f.live);
    list.push_back(f.is_boundary);
  }
  return list;
}

}  // namespace

Json to_json_value(const MeshDump& mesh) {
  Json h = Json::array();
  for (const HalfedgeRecord& r : mesh.halfedges) {
    for (const std::uint32_t number : {r.next, r.twin, r.vertex, r.edge, r.face, r.live})
      h.push_back(number);
  }
  Json v = Json::array();
  Json p = Json::array();
  for (const VertexRecord& r : mesh.vertices) {
    v.push_back(r.halfedge);
    v.push_back(r.live);
    for (const double x : r.position)
      p.push_back(x);
  }
  Json e = Json::array();
  for (const EdgeRecord& r : mesh.edges) {
    e.push_back(r.halfedge);
    e.push_back(r.live);
  }
  return {{"h", std::move(h)},
          {"v", std::move(v)},
          {"p", std::move(p)},
          {"e", std::move(e)},
          {"f", faces_value(mesh.faces)},
          {"b", faces_value(mesh.boundaries)}};
}

Json to_json_value(const std::vector<PointerChange>& changes) {
  Json list = Json::array();
  for (const PointerChange& c : changes) {
    list.push_back({{"element", c.element},
                    {"pointer", c.pointer},
                    {"before", c.before},
                    {"after", c.after}});
  }
  return list;
}

Json to_json_value(const std::vector<RuleBreak>& breaks) {
  Json list = Json::array();
  for (const RuleBreak& b : breaks) {
    list.push_back({{"rule", b.rule},
                    {"meaning", rule_meaning(b.rule)},
                    {"element", b.element},
                    {"expected", b.expected},
                    {"actual", b.actual},
                    {"look_at", b.look_at}});
  }
  return list;
}

Json to_json_value(const MeshScene& scene) {
  Json value{{"step", scene.step}};
  value["edge"] = scene.edge == kUnsetRef ? Json(nullptr) : Json(scene.edge);
  value["before"] = to_json_value(scene.before);
  value["yours"] = to_json_value(scene.yours);
  value["expected"] = to_json_value(scene.expected);
  value["broken"] = to_json_value(find_broken_rules(scene.yours, scene.faces));
  value["changes"] = to_json_value(find_changes(scene.before, scene.yours));
  return value;
}

}  // namespace meshgrade
