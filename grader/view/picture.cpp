#include "grader/view/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
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
          {"smooth", request.smooth},
          {"normals", request.normals},
          {"compare", request.compare}};
}

/// x, y and z of each; null where there is none.
Json numbers_of(const std::vector<Point3>& normals) {
  Json list = Json::array();
  for (const Point3& normal : normals) {
    for (const double x : normal)
      list.push_back(std::isfinite(x) ? Json(x) : Json(nullptr));
  }
  return list;
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
                         const std::vector<Point3>& normals, const std::string& page) {
  Json panels = Json::array();
  for (const ViewLevel& level : shown_states(session, request)) {
    panels.push_back({{"caption", caption_of(session, level)},
                      {"state", state_value(session, level.position)}});
  }
  if (!normals.empty()) panels.back()["normals"] = numbers_of(normals);
  const Json data{{"kind", "picture"},
                  {"panels", std::move(panels)},
                  {"request", request_value(request)},
                  {"title", picture_title(session)}};
  return fill_page(page, data, PageAccess::kNone);
}

std::string picture_svg(const MeshSession& session, const PictureRequest& request,
                        const std::vector<Point3>& normals) {
  std::vector<PicturePanel> panels;
  for (const ViewLevel& level : shown_states(session, request)) {
    const ViewState& state = session.states()[level.position];
    panels.push_back({caption_of(session, level), state.mesh, state.deviation});
  }
  panels.back().normals = normals;
  return picture_svg(panels, request, picture_title(session), description_of(session, request));
}

std::string svg_page(const std::string& svg) {
  return "<!doctype html><meta charset=\"utf-8\"><style>html,body{margin:0}svg{display:block}"
         "</style>" +
         svg;
}

MeshDump drawn_surface(const PatchLook& look) {
  MeshDump mesh;
  const std::size_t side = static_cast<std::size_t>(look.density) + 1;
  for (const std::vector<std::optional<Point3>>& grid : look.grids) {
    const auto first = static_cast<Ref>(mesh.vertices.size());
    for (const std::optional<Point3>& p : grid) {
      mesh.vertices.push_back({kUnsetRef, p ? 1U : 0U, p.value_or(Point3{0.0, 0.0, 0.0})});
    }
    for (std::size_t c = 0; c + side + 1 < grid.size(); ++c) {
      const std::array<std::size_t, 4> corners{c, c + 1, c + side + 1, c + side};
      const bool whole = c % side + 1 < side &&
                         std::all_of(corners.begin(), corners.end(),
                                     [&](std::size_t k) { return grid[k].has_value(); });
      if (!whole) continue;
      const auto start = static_cast<Ref>(mesh.halfedges.size());
      for (Ref k = 0; k < 4; ++k) {
        HalfedgeRecord h{};
        h.live = 1;
        h.twin = h.edge = kUnsetRef;
        h.vertex = first + static_cast<Ref>(corners[k]);
        h.next = start + (k + 1) % 4;
        h.face = static_cast<Ref>(mesh.faces.size());
        mesh.halfedges.push_back(h);
      }
      mesh.faces.push_back({start, 1, 0});
    }
  }
  return mesh;
}

std::string patch_svg(const PatchLook& look, const PictureRequest& request,
                      const std::string& title) {
  PictureRequest upright = request;
  upright.z_up = true;
  upright.ids = false;
  const MeshDump mesh = drawn_surface(look);
  const Deviation none;
  return picture_svg({{"", mesh, none}}, upright, printable(title), printable(title));
}

}  // namespace meshgrade
