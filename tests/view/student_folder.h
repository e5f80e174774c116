#pragma once

// A student's folder that the viewer compiles, with files that can be changed while it runs.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "grader/view/mesh_session.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/scratch_files.h"
#include "tests/support/standard_assignment.h"
#include "tests/support/submissions.h"

namespace meshgrade {

inline std::string reference_file(const std::string& name) {
  std::ifstream stream(test_home().reference / name);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A whole function of the mesh, as a file of its own.
inline std::string mesh_function(const std::string& head, const std::string& body) {
  return "#include \"meshedit/meshedit.h\"\nnamespace meshedit {\n" + head + " {\n" + body +
         "\n}\n}\n";
}
inline std::string flip_file(const std::string& body) {
  return mesh_function("EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0)", body);
}
inline std::string normal_of_vertex(const std::string& body) {
  return mesh_function("Vector3D Vertex::normal() const", body);
}

class StudentFolder {
 public:
  /// Holds these files of the reference.
  explicit StudentFolder(const std::vector<std::string>& right) {
    for (const std::string& name : right)
      write(name, reference_file(name));
  }

  void write(const std::string& name, const std::string& text) const {
    write_file(folder_.path() / name, text);
  }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  ScratchFolder folder_;
};

/// A submission that was built, and a session that looks at a mesh with it.
struct Student {
  explicit Student(const std::vector<std::string>& right, const std::string& mesh = "cube.obj",
                   const std::string& changed_file = "", const std::string& text = "")
      : folder(right) {
    if (!changed_file.empty()) folder.write(changed_file, text);
    program.emplace(standard_rubric(), test_home(), folder.path());
    session.emplace(*program);
    session->open(mesh, sample_polygons(mesh));
    session->rebuild();
  }

  const MeshDump& mesh() const { return session->states()[session->position()].mesh; }

  StudentFolder folder;
  std::optional<StudentProgram> program;
  std::optional<MeshSession> session;
};

}  // namespace meshgrade
