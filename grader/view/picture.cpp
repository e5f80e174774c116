#include "grader/view/picture.h"

#include <nlohmann/json.hpp>

#include "grader/base/text.h"
#include "grader/report/html_report.h"
#include "grader/view/deviation_scale.h"
#include "grader/view/picture_svg.h"
#include "grader/view/view_json.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

std::string counts_text(const MeshDump& mesh) {
  const Counts counts = count(mesh);
  return std::to_string(counts.vertices) + " vertices, " + plural(counts.edges, "edge") + ", " +
         plural(counts.faces, "face");
}

/// What is shown: the state that is looked at, or the last one of each level.
std::vector<ViewLevel> shown_states(const MeshSession& session, const PictureRequest& request) {
  if (request.levels) return session.levels();
  return {{"", session.position()}};
}

std::string caption_of(const MeshSession& session, const ViewLevel& level) {
  if (level.label.empty()) return {};
  return level.label + ": " +
         std::to_string(count(session.states()[level.position].mesh).vertices) + " vertices";
}

Json request_value(const PictureRequest& request) {
  const Camera& camera = request.camera;
  return {{"camera",
           {{"azimuth", camera.azimuth},
            {"elevation", camera.elevation},
            {"distance", camera.distance}}},
          {"width", request.size.width},
          {"height", request.size.height},
          {"wireframe", request.wireframe},
          {"ids", request.ids},
          {"compare", request.compare}};
}

std::string description_of(const MeshSession& session, const PictureRequest& request) {
  std::string text = picture_title(session);
  const ViewState& state = session.states()[session.position()];
  if (request.compare && !state.deviation.empty()) {
    text += "\n" + deviation_text(state.deviation);
    for (const Ref v : shown_worst(state.deviation))
      text += "\n" + deviation_text(state.deviation, v);
  }
  return printable(text);
}

}  // namespace

std::string picture_title(const MeshSession& session) {
  std::vector<std::string> steps;
  for (std::size_t i = 0; i < session.position(); ++i)
    steps.push_back(operation_text(session.operations()[i]));
  return printable(session.name()) + (steps.empty() ? "" : ": " + join(steps, ", ")) + "; " +
         counts_text(session.states()[session.position()].mesh);
}

std::string picture_page(const MeshSession& session, const PictureRequest& request,
                         const std::string& page) {
  Json panels = Json::array();
  for (const ViewLevel& level : shown_states(session, request)) {
    panels.push_back({{"caption", caption_of(session, level)},
                      {"state", state_value(session, level.position)}});
  }
  const Json data{{"kind", "picture"},
                  {"panels", std::move(panels)},
                  {"request", request_value(request)},
                  {"title", picture_title(session)}};
  return fill_page(page, data, PageAccess::kNone);
}

std::string picture_svg(const MeshSession& session, const PictureRequest& request) {
  std::vector<PicturePanel> panels;
  for (const ViewLevel& level : shown_states(session, request)) {
    const ViewState& state = session.states()[level.position];
    panels.push_back({caption_of(session, level), state.mesh, state.deviation});
  }
  return picture_svg(panels, request, picture_title(session), description_of(session, request));
}

}  // namespace meshgrade
