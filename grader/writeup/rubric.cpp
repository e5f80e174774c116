#include "grader/writeup/rubric.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "grader/assignment/toml_section.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/files/bezier_file.h"
#include "grader/files/mesh_file.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// Only what is safe in the name of a file everywhere.
bool is_plain(const std::string& name) {
  return !name.empty() && name.size() <= 60 &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_';
         });
}

class RubricReader {
 public:
  RubricReader(fs::path folder, fs::path meshes, const std::vector<ViewVerb>& verbs)
      : folder_(std::move(folder)), meshes_(std::move(meshes)), verbs_(verbs) {}

  WriteupRubric read(TomlSection& root) {
    if (root.require<std::int64_t>("version") != 1) root.fail_at("version", "must be 1");
    WriteupRubric rubric;
    rubric.title = root.require<std::string>("title");
    for (TomlSection& section : root.sections("part"))
      rubric.parts.push_back(read_part(section));
    root.refuse_unknown_keys();
    return rubric;
  }

 private:
  RubricPart read_part(TomlSection& section) {
    RubricPart part;
    part.heading = section.require<std::string>("heading");
    part.asks = section.get<std::string>("asks", "");
    for (TomlSection& picture : section.sections_if_any("picture"))
      add_pictures(picture, part.pictures);
    section.refuse_unknown_keys();
    return part;
  }

  void add_pictures(TomlSection& section, std::vector<PicturePlan>& pictures) {
    PicturePlan plan;
    plan.place = section.place();
    plan.name = section.require<std::string>("name");
    plan.caption = section.require<std::string>("caption");
    if (!is_plain(plan.name)) {
      section.fail_at("name", "must be of small letters, digits and _, at most 60");
    }
    const auto kind = section.require<std::string>("kind");
    told_at(section, "size", [&](const std::string& text) {
      if (!text.empty()) plan.request.size = parse_size(text);
    });
    plan.file = find_file(section);
    if (kind == "curve") {
      add_curves(section, plan, pictures);
    } else if (kind == "patch") {
      read_patch(section, plan);
      pictures.push_back(std::move(plan));
    } else if (kind == "mesh") {
      read_mesh_picture(section, plan);
      pictures.push_back(std::move(plan));
    } else {
      section.fail_at("kind", "must be \"curve\", \"patch\" or \"mesh\"");
    }
    section.refuse_unknown_keys();
    for (const PicturePlan& made : pictures) {
      if (made.place == section.place() && !names_.insert(made.name).second) {
        section.fail_at("name", "\"" + made.name + "\" is there twice");
      }
    }
  }

  fs::path find_file(TomlSection& section) {
    const auto name = section.require<std::string>("file");
    for (const fs::path& folder : {folder_, meshes_}) {
      std::error_code error;
      if (fs::is_regular_file(folder / name, error)) return folder / name;
    }
    section.fail_at("file", "names \"" + printable(name) + "\", which is neither in " +
                                folder_.string() + " nor in " + meshes_.string());
  }

  /// Reads a text and tells what is wrong with it at its line.
  template <class Take>
  static void told_at(TomlSection& section, const std::string& key, const Take& take) {
    try {
      take(section.get<std::string>(key, ""));
    } catch (const UserError& error) {
      if (section.has(key)) section.fail_at(key, std::string("is wrong: ") + error.what());
      throw;
    }
  }

  template <class Read>
  static auto read_at(TomlSection& section, const Read& read) {
    try {
      return read();
    } catch (const UserError& error) {
      section.fail_at("file", std::string("cannot be read: ") + error.what());
    }
  }

  static void add_curves(TomlSection& section, PicturePlan& plan,
                         std::vector<PicturePlan>& pictures) {
    plan.kind = PictureKind::kCurve;
    plan.points = read_at(section, [&] { return read_bzc(plan.file); });
    plan.t = section.get("t", 0.5);
    if (!(plan.t >= 0.0 && plan.t <= 1.0)) section.fail_at("t", "must be from 0 to 1");
    if (!section.get("each_level", false)) {
      pictures.push_back(std::move(plan));
      return;
    }
    for (std::size_t level = 0; level < plan.points.size(); ++level) {
      PicturePlan one = plan;
      one.levels_shown = level;
      one.name += "_" + std::to_string(level);
      one.caption += level == 0 ? ": the control points"
                     : level + 1 == plan.points.size()
                         ? ": the last level, the point on the curve"
                         : ": level " + std::to_string(level);
      pictures.push_back(std::move(one));
    }
  }

  static void read_patch(TomlSection& section, PicturePlan& plan) {
    plan.kind = PictureKind::kPatch;
    plan.nets = read_at(section, [&] { return read_bez(plan.file); });
    plan.density = static_cast<int>(section.get_positive("density", 8));
    if (plan.density > 64) section.fail_at("density", "must be at most 64");
    read_camera(section, plan.request);
  }

  static void read_camera(TomlSection& section, PictureRequest& request) {
    told_at(section, "camera", [&](const std::string& text) {
      if (!text.empty()) request.camera = parse_camera(text);
    });
  }

  void read_mesh_picture(TomlSection& section, PicturePlan& plan) {
    plan.kind = PictureKind::kMesh;
    plan.mesh = read_at(section, [&] { return read_mesh(plan.file).mesh; });
    told_at(section, "steps", [&](const std::string& text) {
      if (!text.empty()) plan.request.steps = parse_steps(text, verbs_);
    });
    read_camera(section, plan.request);
    plan.request.levels = section.get("levels", false);
    plan.request.wireframe = section.get("wireframe", false);
    plan.request.ids = section.get("ids", false);
    plan.request.compare = section.get("compare", false);
    plan.request.normals = section.get("normals", false);
    const auto shading = section.get<std::string>("shading", "flat");
    if (shading != "flat" && shading != "smooth") {
      section.fail_at("shading", "must be \"flat\" or \"smooth\"");
    }
    plan.request.smooth = shading == "smooth";
  }

  fs::path folder_;
  fs::path meshes_;
  const std::vector<ViewVerb>& verbs_;
  std::set<std::string> names_;
};

}  // namespace

WriteupRubric read_rubric(const fs::path& file, const fs::path& meshes,
                          const std::vector<ViewVerb>& verbs) {
  const std::string name = file.string();
  const std::string text = read_whole_file(file);
  try {
    const toml::table table = toml::parse(text, name);
    TomlSection root(table, name, "");
    return RubricReader(file.parent_path(), meshes, verbs).read(root);
  } catch (const toml::parse_error& error) {
    throw UserError(name + ":" + std::to_string(error.source().begin.line) + ": " +
                    std::string(error.description()));
  }
}

}  // namespace meshgrade
