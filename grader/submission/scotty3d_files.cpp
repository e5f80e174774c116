#include "grader/submission/scotty3d_files.h"

#include <algorithm>

#include "grader/submission/code_only.h"
#include "grader/submission/course_files.h"
#include "grader/submission/function_extents.h"

namespace meshgrade {
namespace {

using Names = std::set<std::string>;

#define SCOTTY3D_NAMES(exercise, ours, theirs) \
  {#exercise, "PolyMesh::" #ours, "Halfedge_Mesh::" #theirs},

const std::vector<Scotty3dFunction>& functions_since_2022() {
  static const std::vector<Scotty3dFunction> functions{
#define SCOTTY3D_FUNCTION(exercise, ours, theirs, Result, Argument) \
  SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_FUNCTION_OF_TWO(exercise, ours, theirs, Result, Argument) \
  SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_MESH_FUNCTION(exercise, ours, theirs, Result) \
  SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_MESH_FUNCTION_OF(exercise, ours, theirs, Result, OurArgument, Argument) \
  SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_REFINEMENT(exercise, ours, theirs) SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_REMESHING(exercise, ours, theirs) SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_PLACEMENT(exercise, ours, theirs) SCOTTY3D_NAMES(exercise, ours, theirs)
#include "include/dropin_scotty3d/functions.inc"
  };
  return functions;
}

const std::vector<Scotty3dFunction>& functions_until_2022() {
  static const std::vector<Scotty3dFunction> functions{
#define SCOTTY3D_FUNCTION(exercise, ours, theirs, Result, Argument) \
  SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_MESH_FUNCTION(exercise, ours, theirs, Result) \
  SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_REFINEMENT(exercise, ours, theirs) SCOTTY3D_NAMES(exercise, ours, theirs)
#include "include/dropin_scotty3d_2020/functions.inc"
  };
  return functions;
}

#undef SCOTTY3D_NAMES

Names names_of(const std::vector<Scotty3dFunction>& functions) {
  Names names;
  for (const Scotty3dFunction& function : functions)
    names.insert(function.their_name);
  return names;
}

bool defines_one_of(const SourceFile& file, const Names& names) {
  const std::vector<FunctionExtent> functions = find_functions(file.text);
  return std::any_of(functions.begin(), functions.end(), [&](const FunctionExtent& function) {
    return names.count(function.name) != 0;
  });
}

bool defines_graded_function(const SourceFile& file) {
  return defines_one_of(file, scotty3d_graded_functions(Dialect::kScotty3d)) ||
         defines_one_of(file, scotty3d_graded_functions(Dialect::kScotty3d2020));
}

bool has(const std::string& code, const std::set<std::string>& parts) {
  return std::any_of(parts.begin(), parts.end(), [&](const std::string& part) {
    return code.find(part) != std::string::npos;
  });
}

/// What later years have neither as a student's function nor as the course's own.
bool is_until_2022(const SourceFile& file) {
  static const Names own{"Halfedge_Mesh::bevel_face",
                         "Halfedge_Mesh::bevel_vertex_positions",
                         "Halfedge_Mesh::bevel_edge_positions",
                         "Halfedge_Mesh::bevel_face_positions",
                         "Halfedge_Mesh::linear_subdivide_positions",
                         "Halfedge_Mesh::catmullclark_subdivide_positions"};
  const std::string code = squeeze(code_only(file.text));
  if (has(code, {"emplace_vertex", "emplace_edge", "emplace_face", "emplace_halfedge"}))
    return false;
  return defines_one_of(file, own) ||
         has(code, {"->next()", "->twin()", "->halfedge()", "->_next", "new_vertex("});
}

}  // namespace

const std::vector<Scotty3dFunction>& scotty3d_functions(Dialect dialect) {
  static const std::vector<Scotty3dFunction> none;
  if (dialect == Dialect::kScotty3d) return functions_since_2022();
  return dialect == Dialect::kScotty3d2020 ? functions_until_2022() : none;
}

const std::set<std::string>& scotty3d_graded_functions(Dialect dialect) {
  static const Names none;
  static const Names since_2022 = names_of(functions_since_2022());
  static const Names until_2022 = names_of(functions_until_2022());
  if (dialect == Dialect::kScotty3d) return since_2022;
  return dialect == Dialect::kScotty3d2020 ? until_2022 : none;
}

bool is_scotty3d_homework_name(const std::string& name) {
  return name == "halfedge-local.cpp" || name == "halfedge-global.cpp" ||
         name == "meshedit.cpp" || name == "meshEdit.cpp";
}

std::optional<Dialect> scotty3d_years_of(const std::vector<SourceFile>& files) {
  bool is_homework = false;
  bool is_early = false;
  for (const SourceFile& file : files) {
    if (!is_source_name(file.name)) continue;
    if (file.name == "halfedge-local.cpp" || file.name == "halfedge-global.cpp")
      return Dialect::kScotty3d;
    if (!defines_graded_function(file)) continue;
    is_homework = true;
    is_early = is_early || is_until_2022(file);
  }
  if (!is_homework) return std::nullopt;
  return is_early ? Dialect::kScotty3d2020 : Dialect::kScotty3d;
}

bool is_first_scotty3d_homework(const std::vector<SourceFile>& files) {
  return std::any_of(files.begin(), files.end(), [](const SourceFile& file) {
    return has(squeeze(code_only(file.text)) + " ",
               {"namespace CMU462{", "namespace CMU462;", "namespace CMU462 "});
  });
}

bool is_scotty3d_course_file(const SourceFile& file, Dialect dialect) {
  static const Names of_geometry{"halfedge", "halfedge-utility",
                                 "indexed",  "spline",
                                 "util",     "meshedit",
                                 "mathlib",  "log",
                                 "vec2",     "vec3",
                                 "vec4",     "mat4",
                                 "main"};
  // Beside meshedit.cpp until Spring 2022, where all homework lies in one folder. A debug.h is
  // the student's: it is there to be added to.
  static const Names of_student{"bbox",      "bsdf",   "bvh",       "camera",     "debug",
                                "env_light", "light",  "particles", "pathtracer", "ray",
                                "samplers",  "shapes", "skeleton",  "tri_mesh"};
  const std::string stem = file.name.substr(0, file.name.rfind('.'));
  const bool is_beside = dialect == Dialect::kScotty3d2020 && file.name != "debug.h" &&
                         of_student.count(stem) != 0;
  if (of_geometry.count(stem) == 0 && !is_beside) return false;
  return !is_source_name(file.name) || !defines_graded_function(file);
}

}  // namespace meshgrade
