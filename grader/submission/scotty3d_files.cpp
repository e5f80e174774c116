#include "grader/submission/scotty3d_files.h"

#include <algorithm>

#include "grader/submission/code_only.h"
#include "grader/submission/course_files.h"
#include "grader/submission/function_extents.h"

namespace meshgrade {
namespace {

bool defines_scotty3d_function(const SourceFile& file) {
  const std::vector<FunctionExtent> functions = find_functions(file.text);
  return std::any_of(functions.begin(), functions.end(), [](const FunctionExtent& function) {
    return scotty3d_graded_functions().count(function.name) != 0;
  });
}

/// As until Spring 2022, when the student's file was another one.
bool has_pointers_as_functions(const SourceFile& file) {
  const std::string code = squeeze(code_only(file.text));
  const auto holds = [&](const char* part) { return code.find(part) != std::string::npos; };
  return !holds("emplace_") && (holds("->next()") || holds("->twin()") ||
                                holds("->halfedge()") || holds("new_vertex("));
}

}  // namespace

const std::vector<Scotty3dFunction>& scotty3d_functions() {
  static const std::vector<Scotty3dFunction> functions{
#define SCOTTY3D_NAMES(exercise, ours, theirs) \
  {#exercise, "PolyMesh::" #ours, "Halfedge_Mesh::" #theirs},
#define SCOTTY3D_FUNCTION(exercise, ours, theirs, Result, Argument) \
  SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_FUNCTION_OF_TWO(exercise, ours, theirs, Result, Argument) \
  SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_MESH_FUNCTION(exercise, ours, theirs, Result) \
  SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_MESH_FUNCTION_OF(exercise, ours, theirs, Result, OurArgument, Argument) \
  SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_REFINEMENT(exercise, ours, theirs) SCOTTY3D_NAMES(exercise, ours, theirs)
#define SCOTTY3D_PLACEMENT(exercise, ours, theirs) SCOTTY3D_NAMES(exercise, ours, theirs)
#include "include/dropin_scotty3d/functions.inc"
#undef SCOTTY3D_NAMES
  };
  return functions;
}

const std::set<std::string>& scotty3d_graded_functions() {
  static const std::set<std::string> names = [] {
    std::set<std::string> all;
    for (const Scotty3dFunction& function : scotty3d_functions())
      all.insert(function.their_name);
    return all;
  }();
  return names;
}

bool is_scotty3d_homework_name(const std::string& name) {
  return name == "halfedge-local.cpp" || name == "halfedge-global.cpp";
}

bool is_scotty3d_homework(const std::vector<SourceFile>& files) {
  return std::any_of(files.begin(), files.end(), [](const SourceFile& file) {
    if (!is_source_name(file.name)) return false;
    if (is_scotty3d_homework_name(file.name)) return true;
    return defines_scotty3d_function(file) && !has_pointers_as_functions(file);
  });
}

bool is_earlier_scotty3d_homework(const std::vector<SourceFile>& files) {
  return std::any_of(files.begin(), files.end(), [](const SourceFile& file) {
    return is_source_name(file.name) && defines_scotty3d_function(file) &&
           has_pointers_as_functions(file);
  });
}

bool is_scotty3d_course_file(const SourceFile& file) {
  static const std::set<std::string> stems{"halfedge", "halfedge-utility",
                                           "indexed",  "spline",
                                           "util",     "meshedit",
                                           "mathlib",  "log",
                                           "vec2",     "vec3",
                                           "vec4",     "mat4",
                                           "main"};
  if (stems.count(file.name.substr(0, file.name.rfind('.'))) == 0) return false;
  return !is_source_name(file.name) || !defines_scotty3d_function(file);
}

}  // namespace meshgrade
