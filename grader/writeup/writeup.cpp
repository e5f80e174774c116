#include "grader/writeup/writeup.h"

#include <algorithm>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/view/browser.h"
#include "grader/view/curve_svg.h"
#include "grader/view/picture.h"
#include "grader/view/picture_file.h"

namespace meshgrade {
namespace {

/// What the judge says, if it is not that all is right: "flip e3: failed", "at ...".
std::string trouble(const CaseReport& told, const std::string& step) {
  if (told.verdict == Verdict::kPassed) return {};
  std::vector<std::string> lines{step + ": " + verdict_name(told.verdict)};
  if (!told.note.empty()) lines.push_back(told.note);
  if (!told.findings.empty()) {
    const Finding& finding = told.findings[0].finding;
    lines.push_back(finding.rule + (finding.meaning.empty() ? "" : ": " + finding.meaning));
    const std::pair<const char*, const std::string*> parts[] = {
        {"at ", &finding.element},
        {"expected ", &finding.expected},
        {"yours ", &finding.actual}};
    for (const auto& [name, text] : parts) {
      if (!text->empty()) lines.push_back(name + *text);
    }
  }
  return join(lines, "\n") + "\n";
}

class PictureMaker {
 public:
  PictureMaker(StudentProgram& program, const WriteupSetup& setup)
      : program_(program), setup_(setup) {}

  WriteupPicture make(const PicturePlan& plan) const {
    switch (plan.kind) {
      case PictureKind::kCurve:
        return curve(plan);
      case PictureKind::kPatch:
        return patch(plan);
      default:
        return mesh(plan);
    }
  }

 private:
  WriteupPicture written(const PicturePlan& plan, const Drawing& drawing,
                         const std::string& told) const {
    const std::string extension = setup_.svg || find_browser().empty() ? ".svg" : ".png";
    const std::filesystem::path out =
        setup_.folder / kWriteupPictures / (plan.name + extension);
    const WrittenPicture there = write_picture(out, drawing, plan.request);
    return {std::string(kWriteupPictures) + "/" + there.file.filename().string(), plan.caption,
            printable_lines(told)};
  }

  static std::string printable_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (const std::string& line : split_lines(text))
      lines.push_back(printable(line));
    return join(lines, "\n");
  }

  WriteupPicture curve(const PicturePlan& plan) const {
    const CurveLook look = look_at_curve(program_, plan.points, plan.t);
    const auto svg = [&] {
      return curve_svg(look, plan.levels_shown, plan.request, plan.caption);
    };
    // The control points are right whatever the function does.
    const std::string told =
        plan.levels_shown == 0
            ? ""
            : trouble(look.told, "evaluateStep at t = " + number_text(plan.t));
    return written(plan, {[&] { return svg_page(svg()); }, svg}, told);
  }

  WriteupPicture patch(const PicturePlan& plan) const {
    const PatchLook look = look_at_patches(program_, plan.nets, plan.density);
    const auto svg = [&] { return patch_svg(look, plan.request, plan.caption); };
    return written(plan, {[&] { return svg_page(svg()); }, svg},
                   trouble(look.told, "evaluate"));
  }

  WriteupPicture mesh(const PicturePlan& plan) const {
    MeshSession session(program_);
    try {
      session.open(plan.file.filename().string(), plan.mesh);
    } catch (const UserError& error) {
      throw UserError(plan.place + ": " + plan.file.string() + ": " + error.what());
    }
    std::string told = run_steps(session, plan);
    std::vector<Point3> normals;
    if (plan.request.smooth || plan.request.normals) {
      const MeshSession::Normals asked = session.normals();
      if (asked.normals.empty()) {
        told += "Vertex::normal: " + asked.told.note + "\n";
      } else {
        normals = session.normals_by_number(asked);
      }
    }
    const auto page = [&] { return picture_page(session, plan.request, normals, setup_.page); };
    const auto svg = [&] { return picture_svg(session, plan.request, normals); };
    return written(plan, {page, svg}, told);
  }

  static std::string run_steps(MeshSession& session, const PicturePlan& plan) {
    std::string told;
    for (const ViewOperation& step : plan.request.steps) {
      const std::string name = operation_text(step);
      try {
        session.apply(step);
      } catch (const UserError& error) {
        // The step before may have gone wrong such that the edge is not there.
        if (told.empty()) throw UserError(plan.place + ": " + name + ": " + error.what());
        return told + name + " could not be tried: " + error.what() + "\n";
      }
      if (session.stopped()) {
        return told + trouble(session.stopped()->told, name) +
               "The picture shows the mesh before this step.\n";
      }
      // What comes after a broken mesh is not judged, and tells nothing more.
      if (told.empty()) told = trouble(session.states()[session.position()].told, name);
    }
    return told;
  }

  StudentProgram& program_;
  const WriteupSetup& setup_;
};

}  // namespace

Writeup make_writeup(const WriteupRubric& rubric, StudentProgram& program,
                     const WriteupSetup& setup,
                     const std::function<void(const WriteupPicture&)>& say) {
  const PictureMaker maker(program, setup);
  Writeup writeup{rubric.title, program.name(), {}};
  for (const RubricPart& part : rubric.parts) {
    WriteupPart& made = writeup.parts.emplace_back(WriteupPart{part.heading, part.asks, {}});
    for (const PicturePlan& plan : part.pictures) {
      made.pictures.push_back(maker.make(plan));
      say(made.pictures.back());
    }
  }
  return writeup;
}

bool is_right(const Writeup& writeup) {
  return std::all_of(writeup.parts.begin(), writeup.parts.end(), [](const WriteupPart& part) {
    return std::all_of(part.pictures.begin(), part.pictures.end(),
                       [](const WriteupPicture& picture) { return picture.told.empty(); });
  });
}

}  // namespace meshgrade
