#include "grader/commands/screenshot.h"

#include <unistd.h>

#include <iostream>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/commands/context.h"
#include "grader/view/curve_svg.h"
#include "grader/view/deviation_scale.h"
#include "grader/view/picture.h"
#include "grader/view/picture_file.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// Says so before minutes of work, not after.
void require_writable(const fs::path& out) {
  const std::string extension = out.extension().string();
  if (extension != ".png" && extension != ".svg") {
    throw UserError(out.string() + ": a screenshot is a .png or an .svg file");
  }
  const fs::path folder = out.has_parent_path() ? out.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw UserError(out.string() + ": there is no folder " + folder.string());
  }
  if (fs::is_directory(out, error)) throw UserError(out.string() + ": is a folder");
  if (::access(folder.c_str(), W_OK) != 0) {
    throw UserError(out.string() + ": cannot be written: the folder is not writable");
  }
}

/// "split e4: failed: split e4 ..., h3.next"
void say_step(const CaseReport& told, const std::string& step) {
  std::cout << step << ": " << verdict_name(told.verdict);
  if (!told.note.empty()) std::cout << ": " << printable(told.note);
  if (!told.findings.empty()) {
    const Finding& finding = told.findings[0].finding;
    std::cout << ": " << finding.rule;
    const std::pair<const char*, const std::string*> parts[] = {
        {": at ", &finding.element},
        {", expected ", &finding.expected},
        {", yours ", &finding.actual}};
    for (const auto& [before, part] : parts) {
      if (!part->empty()) std::cout << before << printable(*part);
    }
  }
  std::cout << "\n";
}

/// How many elements there are of the kind that a step picks.
std::string counts_text(const Counts& counts, const ViewOperation& step) {
  if (step.picks == ElementKind::kEdge) return plural(counts.edges, "edge");
  if (step.picks == ElementKind::kFace) return plural(counts.faces, "face");
  return std::to_string(counts.vertices) + " vertices";
}

/// @return whether all steps came to their end
bool run_steps(MeshSession& session, const std::vector<ViewOperation>& steps) {
  for (const ViewOperation& step : steps) {
    const std::string name = operation_text(step);
    try {
      session.apply(step);
    } catch (const UserError& error) {
      const Counts counts = count(session.states()[session.position()].mesh);
      throw UserError("--steps: step " + std::to_string(session.position() + 1) + ", \"" +
                      name + "\": " + error.what() + "; there are " +
                      counts_text(counts, step) + " then");
    }
    if (session.stopped()) {
      say_step(session.stopped()->told, name);
      std::cout << "The picture shows the mesh before " << name
                << ", which did not come to its end.\n";
      return false;
    }
    say_step(session.states()[session.position()].told, name);
  }
  return true;
}

/// Why nothing can be compared, or what came of it.
void say_comparison(const MeshSession& session) {
  const ViewState& state = session.states()[session.position()];
  const bool subdivided =
      session.position() > 0 && subdivides(session.operations()[session.position() - 1]);
  if (!state.deviation.empty()) {
    std::cout << deviation_text(state.deviation) << "\n";
  } else if (subdivided) {
    std::cout << "Not compared with OpenSubdiv: the mesh is not joined as it must be.\n";
  } else {
    std::cout << "Not compared with OpenSubdiv: the last step is no subdivision.\n";
  }
}

/// The student's normals of what is shown, if they are asked for; says why there are none.
std::vector<Point3> normals_for(const MeshSession& session, const PictureRequest& request) {
  if (!request.smooth && !request.normals) return {};
  const MeshSession::Normals asked = session.normals();
  if (asked.normals.empty()) {
    std::cout << "No normals: " << printable(asked.told.note) << "\n";
    return {};
  }
  return session.normals_by_number(asked);
}

}  // namespace

PictureRequest read_request(const ScreenshotOptions& options,
                            const std::vector<ViewVerb>& verbs) {
  require_writable(options.out);
  PictureRequest request;
  if (!options.steps.empty()) request.steps = parse_steps(options.steps, verbs);
  if (!options.camera.empty()) request.camera = parse_camera(options.camera);
  if (!options.size.empty()) request.size = parse_size(options.size);
  request.wireframe = options.wireframe;
  request.ids = options.ids;
  request.dark = options.dark;
  request.levels = options.levels;
  request.compare = options.compare;
  request.smooth = options.smooth;
  request.normals = options.normals;
  return request;
}

int take_screenshot(MeshSession& session, const PictureRequest& request, const fs::path& out) {
  const bool all_done = run_steps(session, request.steps);
  if (request.compare) say_comparison(session);
  std::cout << picture_title(session) << "\n";
  const std::vector<Point3> normals = normals_for(session, request);
  const auto page = [&] { return picture_page(session, request, normals, viewer_page()); };
  const auto svg = [&] { return picture_svg(session, request, normals); };
  std::cout << write_picture(out, {page, svg}, request).text() << "\n";
  return all_done ? 0 : 1;
}

int take_curve(const StudentProgram& program, const std::vector<Point2>& points,
               const ScreenshotOptions& options, const std::string& name) {
  const PictureRequest request = read_request(options, view_verbs(program.assignment()));
  const CurveLook look = look_at_curve(program, points, options.t);
  say_step(look.told, "evaluateStep at t = " + number_text(options.t));
  const auto levels =
      options.levels_shown < 0 ? points.size() : static_cast<std::size_t>(options.levels_shown);
  const auto svg = [&] { return curve_svg(look, levels, request, printable(name)); };
  std::cout
      << write_picture(options.out, {[&] { return svg_page(svg()); }, svg}, request).text()
      << "\n";
  return look.told.verdict == Verdict::kPassed ? 0 : 1;
}

int take_surface(const StudentProgram& program, const std::vector<ControlNet>& nets,
                 const ScreenshotOptions& options, const std::string& name) {
  const PictureRequest request = read_request(options, view_verbs(program.assignment()));
  const PatchLook look = look_at_patches(program, nets, options.density);
  say_step(look.told, "evaluate");
  const auto svg = [&] { return patch_svg(look, request, name); };
  std::cout
      << write_picture(options.out, {[&] { return svg_page(svg()); }, svg}, request).text()
      << "\n";
  return look.told.verdict == Verdict::kPassed ? 0 : 1;
}

}  // namespace meshgrade
