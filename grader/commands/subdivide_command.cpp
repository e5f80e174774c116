#include "grader/commands/subdivide_command.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <thread>

#include "grader/base/errors.h"
#include "grader/commands/output_check.h"
#include "grader/commands/progress_bar.h"
#include "grader/files/mesh_file.h"
#include "grader/subdivide/direct_catmull_clark.h"
#include "grader/subdivide/direct_loop.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kMostLevels = 15;
constexpr std::size_t kLongWork = 2'000'000;  // faces, from which on a progress bar is shown

struct Arguments {
  fs::path in;
  fs::path out;
  std::string scheme = "loop";
  std::string rule = "loop";
  std::string boundary = "smooth";
  SubdivisionOptions options;
};

std::string counts(std::size_t vertices, std::size_t edges, std::size_t faces) {
  return std::to_string(vertices) + " vertices, " + std::to_string(edges) + " edges, " +
         std::to_string(faces) + " faces";
}

void subdivide_with_progress(DirectSurface& surface, SubdivisionOptions options) {
  ProgressBar bar;
  if (ProgressBar::is_wanted() && surface.n_faces_after(options.levels) >= kLongWork) {
    options.progress = [&bar](double done) { bar.show(done); };
  }
  surface.subdivide(options);
}

std::unique_ptr<DirectSurface> make_surface(const std::string& scheme,
                                            const PolygonMesh& mesh) {
  if (scheme == "catmull-clark") return std::make_unique<DirectCatmullClark>(mesh);
  const bool has_others = std::any_of(mesh.polygons.begin(), mesh.polygons.end(),
                                      [](const auto& polygon) { return polygon.size() != 3; });
  try {
    return std::make_unique<DirectLoop>(mesh);
  } catch (const SubdivisionError& error) {
    if (!has_others) throw;
    throw SubdivisionError(std::string(error.what()) +
                           "; --scheme catmull-clark takes any polygons");
  }
}

void subdivide_file(const Arguments& arguments, const PolygonMesh& mesh) {
  const auto surface = make_surface(arguments.scheme, mesh);
  const std::string before =
      counts(surface->n_vertices(), surface->n_edges(), surface->n_faces());
  subdivide_with_progress(*surface, arguments.options);
  write_mesh(arguments.out, surface->polygon_mesh());
  std::cout << arguments.out.string() << ": "
            << counts(surface->n_vertices(), surface->n_edges(), surface->n_faces())
            << " (before: " << before << ")\n";
}

/// No levels at all: any polygons may pass.
void convert_file(const Arguments& arguments, const PolygonMesh& mesh) {
  write_mesh(arguments.out, mesh);
  std::cout << arguments.out.string() << ": " << mesh.positions.size() << " vertices, "
            << mesh.polygons.size() << " faces, as they were\n";
}

void subdivide_file(const Arguments& arguments) {
  require_mesh_format(arguments.out);
  check_outputs({{"-o", arguments.out}}, {arguments.in});
  const LoadedMesh loaded = read_mesh(arguments.in);
  for (const std::string& note : loaded.notes)
    std::cout << "note: " << note << "\n";
  if (arguments.options.levels == 0) {
    convert_file(arguments, loaded.mesh);
    return;
  }
  try {
    subdivide_file(arguments, loaded.mesh);
  } catch (const SubdivisionError& error) {
    throw UserError(arguments.in.string() + ": " + error.what());
  } catch (const std::bad_alloc&) {
    throw UserError(arguments.in.string() + ": the result does not fit into the memory; take " +
                    "fewer levels than " + std::to_string(arguments.options.levels));
  }
}

/// How the surface is smoothed. @return the option that is of Loop's scheme only
const CLI::Option* add_rules(CLI::App& command, Arguments& arguments) {
  command
      .add_option("--scheme", arguments.scheme,
                  "Loop's, for triangles, or Catmull and Clark's, for any polygons")
      ->check(CLI::IsMember({"loop", "catmull-clark"}))
      ->capture_default_str();
  const CLI::Option* rule =
      command.add_option("--rule", arguments.rule, "Weights of Loop's inner vertices")
          ->check(CLI::IsMember({"loop", "warren"}))
          ->capture_default_str();
  command
      .add_option("--boundary", arguments.boundary,
                  "Boundary vertices of a single face: smooth them, or keep the corner")
      ->check(CLI::IsMember({"smooth", "corner"}))
      ->capture_default_str();
  return rule;
}

}  // namespace

void add_subdivide_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  SubdivisionOptions& options = arguments->options;
  options.threads = std::max(1U, std::thread::hardware_concurrency());

  CLI::App* command =
      app.add_subcommand("subdivide", "Smooth a mesh by Loop or Catmull-Clark subdivision");
  command->add_option("input", arguments->in, "The mesh: .obj .off .ply .stl .gltf .glb .dae")
      ->required();
  command->add_option("-o,--output", arguments->out, "Where to write; same formats")
      ->required();
  command->add_option("-n,--levels", options.levels, "How often each face is divided")
      ->check(CLI::Range(0U, kMostLevels))
      ->capture_default_str();
  const CLI::Option* rule = add_rules(*command, *arguments);
  command
      ->add_option("--threads", options.threads,
                   "The result is the same for every number of threads")
      ->check(CLI::Range(1U, 256U))
      ->capture_default_str();
  command->footer(
      "Examples:\n"
      "  meshgrade subdivide meshes/cube.obj -n 3 -o smooth.obj\n"
      "  meshgrade subdivide scan.stl -n 1 -o scan.glb --rule warren\n"
      "  meshgrade subdivide meshes/grid_4x4.obj -n 2 -o grid.ply --boundary corner\n"
      "  meshgrade subdivide meshes/quad_cube.dae -n 3 -o ball.obj --scheme catmull-clark\n"
      "Exit code: 0 written, 2 bad usage, or a file that cannot be read or written.");
  command->callback([arguments, rule, &exit_code] {
    if (arguments->scheme != "loop" && rule->count() > 0)
      throw UserError("--rule chooses among Loop's weights; Catmull-Clark has one rule only");
    SubdivisionOptions& chosen = arguments->options;
    chosen.vertex_rule = arguments->rule == "loop" ? VertexRule::kLoop : VertexRule::kWarren;
    chosen.corner_rule =
        arguments->boundary == "smooth" ? CornerRule::kSmooth : CornerRule::kCorner;
    subdivide_file(*arguments);
    exit_code = 0;
  });
}

}  // namespace meshgrade
