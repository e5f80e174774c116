#include "tests/dropin/course_project.h"

#include <fstream>
#include <map>
#include <string>

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

/// Files that would mislead whoever takes them for the student's: they name the Bezier classes,
/// also in forms of other years, and do not compile without the course's library.
std::map<std::string, std::string> telling_files() {
  return {
      {"bezierPatch.cpp",
       "#include \"bezierPatch.h\"\nnamespace CGL {\n"
       "BezierPatch::BezierPatch() { controlPoints.resize(4); }\n"
       "void BezierPatch::preprocess() {}\n"
       "void BezierPatch::add2mesh(Polymesh* mesh) const { addPoint(mesh, evaluate(0, 1)); }\n"
       "}\n"},
      {"bezierPatch.h",
       "#include \"CGL/CGL.h\"\nnamespace CGL {\nclass BezierPatch {\n"
       "  Vector3D evaluate1D(std::vector<Vector3D> points, double t) const;\n};\n}\n"},
      {"bezierCurve.cpp",
       "#include \"bezierCurve.h\"\nnamespace CGL {\n"
       "void BezierCurve::drawCurve() {\n  BezierCurve::evaluateStep();\n  glBegin(GL_LINES);\n"
       "}\n}\n"},
      {"bezierCurve.h",
       "#include \"CGL/CGL.h\"\nnamespace CGL {\nclass BezierCurve {\n"
       "  void evaluateStep();\n};\n}\n"},
      {"halfEdgeMesh.cpp",
       "#include \"halfEdgeMesh.h\"\nnamespace CGL {\n"
       "Vector3D Face::normal( void ) const { return areaVector().unit(); }\n}\n"},
      {"meshEdit.cpp",
       "#include \"student_code.h\"\n#include \"meshEdit.h\"\nnamespace CGL {\n"
       "void MeshEdit::flip() { mesh.flipEdge(selected->getEdge()->halfedge()->edge()); "
       "}\n}\n"},
      {"meshEdit.h",
       "#include \"student_code.h\"\nnamespace CGL { class MeshEdit { int width; }; }\n"},
      {"main.cpp",
       "#include \"CGL/CGL.h\"\n#include \"CGL/viewer.h\"\n#include \"meshEdit.h\"\n"
       "int main(int argc, char** argv) { CGL::Viewer viewer; return argc; }\n"},
  };
}

void write_src(const fs::path& src) {
  for (const char* name :
       {"camera", "collada", "light", "material", "mesh", "png", "scene", "texture"}) {
    const std::string header = std::string(name) + ".h";
    write(src / header, "#include \"CGL/matrix4x4.h\"\nnamespace CGL { class C; }\n");
    write(src / (std::string(name) + ".cpp"),
          "#include \"" + header + "\"\nnamespace CGL { int C::draw() { glEnd(); } }\n");
  }
  for (const char* name :
       {"mergeVertices.h", "shaderUtils.h", "mutablePriorityQueue.h", "halfEdgeMesh.h"})
    write(src / name, "#include <vector>\nusing namespace CGL;\n");
  for (const auto& [name, text] : telling_files())
    write(src / name, text);
  write(src / "CMakeLists.txt", "add_executable(meshedit student_code.cpp)\n");
}

}  // namespace

void put_into_course_project(const fs::path& homework, const fs::path& project) {
  write(project / "CMakeLists.txt", "add_subdirectory(src)\n");
  write(project / "README.md", "# Mesh editor\n");
  write(project / "CGL" / "include" / "CGL" / "vector3D.h", "namespace CGL {}\n");
  write(project / "CGL" / "src" / "vector3D.cpp", "#include \"vector3D.h\"\n");
  write(project / "ext" / "glfw" / "window.cpp", "int window;\n");
  write(project / "build" / "src" / "probe.cpp", "int main() {}\n");
  write_src(project / "src");
  for (const fs::directory_entry& file : fs::directory_iterator(homework)) {
    fs::copy(file.path(), project / "src", fs::copy_options::overwrite_existing);
  }
}

}  // namespace meshgrade
