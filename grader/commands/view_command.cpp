#include "grader/commands/view_command.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "grader/base/errors.h"
#include "grader/commands/console.h"
#include "grader/commands/context.h"
#include "grader/commands/file_watch.h"
#include "grader/commands/grading_options.h"
#include "grader/commands/screenshot.h"
#include "grader/files/bezier_file.h"
#include "grader/files/mesh_file.h"
#include "grader/view/view_server.h"

namespace meshgrade {
namespace {

struct ViewOptions {
  std::string mesh;
  std::string submission;
  std::string assignment;
  int port = 0;
  bool no_cache = false;
  ScreenshotOptions screenshot;
};

/// Ctrl-C is taken by a thread of its own, so that the server ends in order.
void end_by_signal(ViewServer& server, std::atomic<bool>& over, const sigset_t& signals) {
  int signal = 0;
  ::sigwait(&signals, &signal);
  over = true;
  server.stop();
}

sigset_t block_signals() {
  sigset_t signals;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, SIGINT);
  ::sigaddset(&signals, SIGTERM);
  ::sigaddset(&signals, SIGHUP);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

/// Builds again after each save. What is wrong with the files now may be right after the next.
void rebuild_on_save(ViewServer& server, const std::filesystem::path& files,
                     const std::atomic<bool>& over) {
  FileWatch watch(files);
  while (watch.wait_for_change([&] { return over.load(); })) {
    try {
      server.change([](MeshSession& session) { session.rebuild(); });
    } catch (const std::exception& error) {
      std::cerr << "meshgrade: " << error.what() << "\n";
    }
  }
}

using Json = nlohmann::ordered_json;

/// What the page begins with, if the file holds no mesh.
Json bezier_start(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (file.extension() == ".bzc") {
    return {{"kind", "curve"}, {"name", name}, {"points", read_bzc(file)}};
  }
  if (file.extension() != ".bez") return nullptr;
  Json patches = Json::array();
  for (const ControlNet& net : read_bez(file)) {
    Json rows = Json::array();
    for (std::size_t row = 0; row < net.rows; ++row) {
      rows.push_back(Json::array());
      for (std::size_t col = 0; col < net.cols; ++col)
        rows.back().push_back(net.at(row, col));
    }
    patches.push_back(std::move(rows));
  }
  return {{"kind", "patch"}, {"name", name}, {"nets", std::move(patches)}};
}

/// Until Ctrl-C.
void serve(MeshSession& session, const ViewOptions& options, const Json& start) {
  const sigset_t signals = block_signals();
  ViewServer server(session, viewer_page(), start.dump());
  server.bind(options.port);
  std::cout << server.address() << "\n"
            << "Open this address in a browser. Saving a file builds it again; Ctrl-C ends.\n"
            << std::flush;
  std::atomic<bool> over{false};
  std::thread watcher(
      [&] { rebuild_on_save(server, std::filesystem::path(options.submission), over); });
  std::thread ender([&] { end_by_signal(server, over, signals); });
  server.serve();
  over = true;
  ::kill(::getpid(), SIGTERM);  // blocked everywhere: `ender` waits for it
  ender.join();
  watcher.join();
}

/// Nothing is said of a file that does not compile but by who compiles it.
void say_what_failed(const StudentProgram& program) {
  for (const BuiltFile& file : program.files()) {
    if (!file.ok) std::cerr << file.name << " does not compile:\n" << file.messages << "\n";
  }
}

int take_bezier(StudentProgram& program, const std::filesystem::path& file,
                const ScreenshotOptions& options) {
  const Progress progress = terminal_progress();
  progress("compiling");
  program.rebuild();
  progress("");
  say_what_failed(program);
  const std::string name = file.filename().string();
  if (file.extension() == ".bzc") return take_curve(program, read_bzc(file), options, name);
  return take_surface(program, read_bez(file), options, name);
}

int view(const ViewOptions& options) {
  const bool for_picture = !options.screenshot.out.empty();
  const Assignment assignment = load_assignment_of(options.assignment, options.submission);
  const std::vector<ViewVerb> verbs = view_verbs(assignment);
  const PictureRequest request =
      for_picture ? read_request(options.screenshot, verbs) : PictureRequest();
  const Home home = find_home({!options.no_cache});
  const std::filesystem::path usual =
      home.meshes / (are_for_polygons(verbs) ? "prism_5.obj" : "cube.obj");
  const std::filesystem::path file =
      options.mesh.empty() ? usual : std::filesystem::path(options.mesh);
  const Json start = bezier_start(file);
  const std::filesystem::path mesh = start.is_null() ? file : usual;
  StudentProgram program(assignment, home, options.submission);
  if (for_picture && !start.is_null()) return take_bezier(program, file, options.screenshot);
  MeshSession session(program);
  const LoadedMesh loaded = read_mesh(mesh);
  try {
    session.open(mesh.filename().string(), loaded.mesh, loaded.notes);
  } catch (const UserError& error) {
    throw UserError(mesh.string() + ": " + error.what());
  }
  for (const std::string& note : loaded.notes)
    std::cerr << mesh.filename().string() << ": note: " << note << "\n";
  const Progress progress = terminal_progress();
  progress("compiling");
  session.rebuild();
  progress("");
  if (for_picture) {
    say_what_failed(program);
    return take_screenshot(session, request, options.screenshot.out);
  }
  serve(session, options, start);
  return 0;
}

void add_screenshot_options(CLI::App& command, ScreenshotOptions& options) {
  const std::string group = "For a picture";
  CLI::Option* out =
      command
          .add_option("--screenshot", options.out,
                      "Writes a picture and ends: a .png, by a browser that needs no display, "
                      "or an .svg, which the grader draws")
          ->group(group);
  const auto add = [&](CLI::Option* option) { option->needs(out)->group(group); };
  add(command.add_option(
      "--steps", options.steps,
      "What your functions do first: \"flip e3, split e5, subdivide 2\", of polygons "
      "\"extrude f2, weld e3 e7, catmull-clark 2\""));
  add(command.add_option("--camera", options.camera,
                         "AZIMUTH,ELEVATION[,DISTANCE]: degrees, 0,0 from the front; 31,22,3.5 "
                         "if not given"));
  add(command.add_option("--size", options.size,
                         "WIDTHxHEIGHT in pixels; 960x720 if not given"));
  add(command.add_flag("--levels", options.levels, "All levels of subdivision side by side"));
  add(command.add_flag("--compare", options.compare,
                       "Colours each vertex by its distance from OpenSubdiv's answer"));
  add(command.add_flag("--wireframe", options.wireframe, "Edges without faces"));
  add(command.add_flag("--ids", options.ids, "The names of the elements"));
  add(command.add_flag("--smooth", options.smooth, "Shaded by your vertex normals"));
  add(command.add_flag("--normals", options.normals, "Your vertex normals as lines"));
  add(command
          .add_option("--t", options.t, "Of a curve: where the levels are; 0.5 if not given")
          ->check(CLI::Range(0.0, 1.0)));
  add(command
          .add_option("--level", options.levels_shown,
                      "Of a curve: how many levels of de Casteljau are drawn; all if not given")
          ->check(CLI::Range(0, 40)));
  add(command
          .add_option("--density", options.density,
                      "Of a surface: samples along each side of a patch; 16 if not given")
          ->check(CLI::Range(1, 64)));
  add(command.add_flag("--dark", options.dark, "On a dark ground"));
}

}  // namespace

void add_view_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command =
      app.add_subcommand("view", "See a mesh, and what your functions make of it");
  command->add_option("mesh", options->mesh,
                      "A mesh, a Bezier curve (.bzc) or surface (.bez); a cube, or a prism of "
                      "polygons, if none "
                      "is named");
  command
      ->add_option("--submission", options->submission,
                   "The folder with the C++ files, or one file")
      ->required();
  command->add_option(
      "--assignment", options->assignment,
      "The assignment: a TOML file, or the name of one that comes along; recognised by "
      "what the files define if not given");
  command->add_option("--port", options->port, "The port to listen on; any free one if 0")
      ->check(CLI::Range(0, 65535));
  add_screenshot_options(*command, options->screenshot);
  add_cache_option(*command, options->no_cache);
  command->footer(
      "Calls your own functions on a mesh, in the browser: those that flip, split and\n"
      "subdivide triangles, or all that edit polygons. A crash or an endless loop is told and\n"
      "nothing is lost; save your file, and the steps are repeated.\n"
      "Examples:\n"
      "  meshgrade view --submission my_homework\n"
      "  meshgrade view meshes/icosahedron.obj --submission my_homework\n"
      "  meshgrade view meshes/arch_4.bzc --submission my_homework\n"
      "  meshgrade view meshes/cube.obj --submission my_homework --screenshot cube.png \\\n"
      "      --steps \"flip e3, split e5, subdivide 2\" --camera 45,30 --levels\n"
      "  meshgrade view meshes/prism_5.obj --submission polygons --screenshot prism.png \\\n"
      "      --steps \"bevel v2, collapse f1, catmull-clark 2\"\n"
      "  meshgrade view meshes/loop_6.bzc --submission my_homework --screenshot curve.png \\\n"
      "      --t 0.3 --level 2\n"
      "  meshgrade view meshes/teapot.bez --submission my_homework --screenshot teapot.png\n"
      "Exit code: 0 when ended by Ctrl-C or the picture is there, 1 a step of the picture did\n"
      "not come to its end, 2 bad usage or an unreadable file, 3 an error of "
      "the\n"
      "grader.");
  command->callback([options, &exit_code] { exit_code = view(*options); });
}

}  // namespace meshgrade
