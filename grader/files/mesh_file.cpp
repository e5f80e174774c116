#include "grader/files/mesh_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "grader/base/safe_file.h"
#include "grader/files/checked_input.h"
#include "grader/files/collada_file.h"
#include "grader/files/file_bytes.h"
#include "grader/files/gltf_file.h"
#include "grader/files/openmesh_files.h"
#include "grader/files/reading_notes.h"
#include "grader/files/weld.h"

namespace meshgrade {
namespace {

using Path = std::filesystem::path;

/// How one format is read from and written to bytes.
struct Format {
  std::string_view extension;
  LoadedMesh (*read)(const Path& file, const std::string& bytes);
  std::string (*write)(const PolygonMesh& mesh);
  std::size_t most_corners;  // of one polygon, in writing
};

constexpr std::size_t kAnyPolygon = std::numeric_limits<std::size_t>::max();

/// By OpenMesh, if anything is left to read.
LoadedMesh read_checked(const std::string& format, const CheckedInput& input) {
  LoadedMesh loaded;
  if (input.n_faces > 0) loaded.mesh = openmesh_read(format, input);
  loaded.notes = input.notes.all();
  return loaded;
}

LoadedMesh read_obj(const Path& file, const std::string& bytes) {
  return read_checked("obj", check_obj(file, bytes));
}

LoadedMesh read_off(const Path& file, const std::string& bytes) {
  return read_checked("off", check_off(file, bytes));
}

LoadedMesh read_ply(const Path& file, const std::string& bytes) {
  return read_checked("ply", check_ply(file, bytes));
}

LoadedMesh read_stl(const Path& file, const std::string& bytes) {
  const CheckedInput input = check_stl(file, bytes);
  // OpenMesh's reader welds while it reads.
  LoadedMesh loaded = read_checked("stl", input);
  if (const std::size_t n_vertices = loaded.mesh.positions.size();
      n_vertices < 3 * input.n_faces) {
    loaded.notes.push_back(weld_note(3 * input.n_faces, n_vertices));
  }
  return loaded;
}

/// Drops faces that have lost their area when corners at one point became one vertex.
void drop_degenerate_faces(const Path& file, PolygonMesh& mesh, ReadingNotes& notes) {
  std::vector<std::vector<std::uint32_t>> kept;
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    auto& polygon = mesh.polygons[f];
    if (admit_polygon(file, "", f, polygon, mesh.positions.size(), 0, notes)) {
      kept.push_back(std::move(polygon));
    }
  }
  mesh.polygons = std::move(kept);
}

LoadedMesh read_gltf(const Path& file, const std::string& bytes) {
  LoadedMesh loaded = parse_gltf(file, bytes);
  const std::string welded = weld(loaded.mesh);
  ReadingNotes notes;
  drop_degenerate_faces(file, loaded.mesh, notes);
  for (const std::string& note : notes.all())
    loaded.notes.push_back(note);
  if (!welded.empty()) loaded.notes.push_back(welded);
  return loaded;
}

const std::array<Format, 7> kFormats = {{
    {".obj", read_obj, [](const PolygonMesh& mesh) { return openmesh_write("obj", mesh); },
     kAnyPolygon},
    {".off", read_off, [](const PolygonMesh& mesh) { return openmesh_write("off", mesh); },
     kAnyPolygon},
    {".ply", read_ply, [](const PolygonMesh& mesh) { return openmesh_write("ply", mesh); },
     255},
    {".stl", read_stl, [](const PolygonMesh& mesh) { return openmesh_write("stl", mesh); }, 3},
    {".gltf", read_gltf, [](const PolygonMesh& mesh) { return format_gltf(mesh, false); }, 3},
    {".glb", read_gltf, [](const PolygonMesh& mesh) { return format_gltf(mesh, true); }, 3},
    {".dae", parse_collada, format_collada, kAnyPolygon},
}};

const Format& format_of(const Path& file) {
  const std::string extension = lower_extension(file);
  std::string known;
  for (const Format& format : kFormats) {
    if (format.extension == extension) return format;
    known += ' ';
    known += format.extension;
  }
  refuse_file(file, "", "unknown mesh format '" + extension + "'; known are" + known);
}

void check_for_writing(const Path& file, const PolygonMesh& mesh, const Format& format) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (const double coordinate : mesh.positions[v]) {
      if (!(std::abs(coordinate) <= std::numeric_limits<float>::max())) {
        refuse_file(file, "",
                    "cannot be written: vertex v" + std::to_string(v) +
                        " has a coordinate that is not a finite number up to 3.4e38");
      }
    }
  }
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    const auto& polygon = mesh.polygons[f];
    if (polygon.size() > format.most_corners) {
      refuse_file(file, "",
                  "cannot be written: face f" + std::to_string(f) + " has " +
                      std::to_string(polygon.size()) + " corners and " +
                      std::string(format.extension) + " allows " +
                      std::to_string(format.most_corners) + "; choose .obj");
    }
    check_polygon(file, f, polygon, mesh.positions.size());
  }
}

/// Vertices of no face have no place on a surface.
void drop_unused_vertices(LoadedMesh& loaded) {
  PolygonMesh& mesh = loaded.mesh;
  std::vector<std::uint32_t> new_index(mesh.positions.size(), 0);
  for (const auto& polygon : mesh.polygons) {
    for (const std::uint32_t v : polygon)
      new_index[v] = 1;
  }
  std::uint32_t n_used = 0;
  for (std::size_t v = 0; v < new_index.size(); ++v) {
    if (new_index[v] == 0) continue;
    mesh.positions[n_used] = mesh.positions[v];
    new_index[v] = n_used++;
  }
  if (n_used == mesh.positions.size()) return;
  ReadingNotes notes;
  notes.left_out("vertex that belongs to no face", "vertices that belong to no face", "",
                 mesh.positions.size() - n_used);
  loaded.notes.push_back(notes.all().front());
  mesh.positions.resize(n_used);
  for (auto& polygon : mesh.polygons) {
    for (std::uint32_t& v : polygon)
      v = new_index[v];
  }
}

[[noreturn]] void refuse_without_faces(const Path& file,
                                       const std::vector<std::string>& notes) {
  std::string what = "holds no faces; export the surface, not points or lines";
  for (std::size_t k = 0; k < notes.size(); ++k)
    what += (k == 0 ? " (" : "; ") + notes[k] + (k + 1 == notes.size() ? ")" : "");
  refuse_file(file, "", what);
}

}  // namespace

LoadedMesh read_mesh(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    refuse_file(file, "", "is a folder; name a file in it");
  }
  const Format& format = format_of(file);
  const std::string bytes = read_bytes(file);
  LoadedMesh loaded = format.read(file, bytes);
  if (loaded.mesh.polygons.empty()) refuse_without_faces(file, loaded.notes);
  drop_unused_vertices(loaded);
  return loaded;
}

void write_mesh(const std::filesystem::path& file, const PolygonMesh& mesh) {
  const Format& format = format_of(file);
  check_for_writing(file, mesh, format);
  write_file_safely(file, format.write(mesh));
}

void require_mesh_format(const std::filesystem::path& file) {
  format_of(file);
}

}  // namespace meshgrade
