#include "grader/view/view_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "grader/report/mesh_json.h"
#include "grader/report/report_value.h"
#include "grader/view/deviation_scale.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;
using WriteMesh = std::function<Json(const MeshDump&)>;

/// Nobody reads a longer list, and that of a large subdivision has millions.
constexpr std::size_t kMostChanges = 20'000;

Json build_value(const StudentProgram& program) {
  Json files = Json::array();
  for (const BuiltFile& file : program.files()) {
    files.push_back({{"name", file.name}, {"compiled", file.ok}, {"messages", file.messages}});
  }
  return {{"number", program.builds()},
          {"compiled", program.compiled()},
          {"files", std::move(files)}};
}

Json to_json_value(const Deviation& deviation) {
  Json colors = Json::array();
  for (const double off : deviation.of_vertex)
    colors.push_back(std::isnan(off) ? Json(nullptr) : Json(deviation_color(deviation, off)));
  Json worst = Json::array();
  for (const Ref v : shown_worst(deviation))
    worst.push_back({{"vertex", vertex_name(v)}, {"text", deviation_text(deviation, v)}});
  return {{"colors", std::move(colors)},
          {"scale", kDeviationColors},
          {"ends", deviation_ends(deviation)},
          {"worst", std::move(worst)},
          {"text", deviation_text(deviation)}};
}

Json timeline_value(const MeshSession& session) {
  Json steps = Json::array();
  steps.push_back({{"label", "start"}, {"verdict", ""}});
  for (std::size_t i = 0; i < session.operations().size(); ++i) {
    steps.push_back({{"label", operation_text(session.operations()[i])},
                     {"subdivides", subdivides(session.operations()[i])},
                     {"verdict", verdict_name(session.states()[i + 1].told.verdict)}});
  }
  return steps;
}

Json verbs_value(const std::vector<ViewVerb>& verbs) {
  Json list = Json::array();
  for (const ViewVerb& verb : verbs) {
    list.push_back({{"word", verb.word},
                    {"keys", verb.keys},
                    {"picks", verb.picked == 0 ? "" : kind_name(verb.picks)},
                    {"picked", verb.picked},
                    {"subdivides", verb.subdivides}});
  }
  return list;
}

Json changes_value(const MeshDump& before, const MeshDump& after) {
  return to_json_value(find_changes(before, after, kMostChanges));
}

Json whole_mesh(const MeshDump& mesh) {
  return to_json_value(mesh);
}

Json state_value(const MeshSession& session, std::size_t position,
                 const WriteMesh& write_mesh) {
  const ViewState& state = session.states()[position];
  const FaceShape faces = faces_of(session.verbs());
  Json value{{"mesh", write_mesh(state.mesh)},
             {"broken", to_json_value(find_broken_rules(state.mesh, faces))}};
  if (position == 0) return value;
  const MeshDump& before = session.mesh_before(position);
  value["step"] = operation_text(session.operations()[position - 1]);
  value["told"] = to_json_value(state.told);
  value["before"] = write_mesh(before);
  value["changes"] = changes_value(before, state.mesh);
  if (!state.told.scene.empty()) value["expected"] = write_mesh(state.told.scene.expected);
  if (!state.deviation.empty()) value["deviation"] = to_json_value(state.deviation);
  return value;
}

}  // namespace

Json state_value(const MeshSession& session, std::size_t position) {
  return state_value(session, position, whole_mesh);
}

Json levels_value(const MeshSession& session) {
  Json list = Json::array();
  for (const ViewLevel& level : session.levels()) {
    list.push_back({{"label", level.label}, {"state", state_value(session, level.position)}});
  }
  return list;
}

Json to_json_value(const MeshSession& session) {
  return to_json_value(session, whole_mesh);
}

Json to_json_value(const MeshSession& session, const WriteMesh& write_mesh) {
  Json value{{"submission", session.program().name()},
             {"mesh", session.name()},
             {"notes", session.notes()},
             {"verbs", verbs_value(session.verbs())},
             {"has_normals", !are_for_polygons(session.verbs())},
             {"build", build_value(session.program())},
             {"timeline", timeline_value(session)},
             {"position", session.position()},
             {"state", state_value(session, session.position(), write_mesh)}};
  if (session.stopped()) {
    const StoppedStep& stop = *session.stopped();
    Json stopped{{"step", operation_text(stop.operation)}, {"told", to_json_value(stop.told)}};
    if (stop.mesh) {
      stopped["mesh"] = write_mesh(*stop.mesh);
      stopped["broken"] =
          to_json_value(find_broken_rules(*stop.mesh, faces_of(session.verbs())));
      stopped["changes"] = changes_value(session.states()[session.position()].mesh, *stop.mesh);
    }
    value["stopped"] = std::move(stopped);
  }
  return value;
}

Json to_json_value(const MeshSession::Normals& normals, const MeshDump& mesh) {
  if (normals.normals.empty()) return {{"error", normals.told.note}};
  Json list = Json::array();
  std::size_t next = 0;
  for (const VertexRecord& v : mesh.vertices) {
    const bool live = v.live != 0 && next < normals.normals.size();
    const Point3 normal = live ? normals.normals[next++] : Point3{0, 0, 0};
    for (const double x : normal)
      list.push_back(x);
  }
  return {{"normals", std::move(list)}};
}

}  // namespace meshgrade
