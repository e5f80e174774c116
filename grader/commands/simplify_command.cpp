#include "grader/commands/simplify_command.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>

#include "grader/base/errors.h"
#include "grader/commands/output_check.h"
#include "grader/commands/progress_bar.h"
#include "grader/files/mesh_file.h"
#include "grader/mesh/build_mesh.h"
#include "grader/simplify/openmesh_decimation.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongDecimation =
    200'000;  // faces, from which on a progress bar is shown

struct Simplification {
  fs::path in;
  fs::path out;
  std::size_t faces = 0;
};

std::string counts_of(const PolygonMesh& mesh) {
  return std::to_string(mesh.positions.size()) + " vertices, " +
         std::to_string(mesh.polygons.size()) + " faces";
}

/// OpenMesh leaves out the faces that no manifold has, without a word.
void require_manifold_of_triangles(const fs::path& file, const PolygonMesh& mesh) {
  const auto other = std::find_if(mesh.polygons.begin(), mesh.polygons.end(),
                                  [](const auto& polygon) { return polygon.size() != 3; });
  if (other != mesh.polygons.end()) {
    throw UserError(file.string() + ": face f" + std::to_string(other - mesh.polygons.begin()) +
                    " has " + std::to_string(other->size()) +
                    " corners; only meshes of triangles are simplified: triangulate it first");
  }
  try {
    meshedit::HalfedgeMesh built;
    build_mesh(mesh, built);
  } catch (const meshedit::MeshError& error) {
    throw UserError(file.string() + ": " + error.what() +
                    "; only a manifold of triangles is simplified");
  }
}

PolygonMesh decimate_with_progress(const PolygonMesh& mesh, std::size_t faces) {
  ProgressBar bar;
  std::function<void(std::size_t)> progress;
  if (ProgressBar::is_wanted() && mesh.polygons.size() >= kLongDecimation) {
    const double collapses = static_cast<double>(mesh.polygons.size() - faces) / 2;
    progress = [&bar, collapses](std::size_t done) {
      bar.show(std::min(1.0, static_cast<double>(done) / collapses));
    };
  }
  return outline_keeping_decimation(mesh, faces, progress);
}

void simplify_file(const Simplification& arguments) {
  require_mesh_format(arguments.out);
  check_outputs({{"-o", arguments.out}}, {arguments.in});
  const LoadedMesh loaded = read_mesh(arguments.in);
  for (const std::string& note : loaded.notes)
    std::cout << "note: " << note << "\n";
  require_manifold_of_triangles(arguments.in, loaded.mesh);
  const bool is_small = loaded.mesh.polygons.size() <= arguments.faces;
  const PolygonMesh left =
      is_small ? loaded.mesh : decimate_with_progress(loaded.mesh, arguments.faces);
  write_mesh(arguments.out, left);
  std::cout << arguments.out.string() << ": " << counts_of(left);
  if (is_small) {
    std::cout << ", as they were\n";
    return;
  }
  std::cout << " (before: " << counts_of(loaded.mesh) << ")\n";
  if (left.polygons.size() > arguments.faces) {
    std::cout
        << "note: no edge is left that can be collapsed without harm to the surface or its "
        << "boundaries, so there are more faces than " << arguments.faces << "\n";
  }
}

}  // namespace

void add_simplify_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Simplification>();
  CLI::App* command = app.add_subcommand(
      "simplify", "Leave fewer triangles of a mesh, where they are missed least");
  command->add_option("input", arguments->in, "The mesh: .obj .off .ply .stl .gltf .glb .dae")
      ->required();
  command->add_option("-o,--output", arguments->out, "Where to write; same formats")
      ->required();
  command->add_option("-f,--faces", arguments->faces, "At most so many triangles are left")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000'000}))
      ->required();
  command->footer(
      "Edges are collapsed by OpenMesh's decimater, those of the least quadric error first\n"
      "(Garland and Heckbert 1997), each to one of its ends. Boundaries stay where they are, "
      "and\n"
      "no triangle turns over.\n"
      "Examples:\n"
      "  meshgrade simplify scan.stl --faces 5000 -o small.stl\n"
      "  meshgrade simplify statue.glb --faces 300 -o statue.obj\n"
      "Exit code: 0 written, 2 bad usage, or a file that cannot be read or written.");
  command->callback([arguments, &exit_code] {
    simplify_file(*arguments);
    exit_code = 0;
  });
}

}  // namespace meshgrade
