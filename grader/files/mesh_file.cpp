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

LoadedMesh read_stl(const Path& file, const std::string& bytes) {
  const CheckedInput input = check_stl(file, bytes);
  // OpenMesh's reader welds while it reads.
  LoadedMesh loaded{openmesh_read("stl", input), {}};
  if (const std::size_t n_vertices = loaded.mesh.positions.size();
      n_vertices < 3 * input.n_faces) {
    loaded.notes.push_back(weld_note(3 * input.n_faces, n_vertices));
  }
  return loaded;
}

LoadedMesh read_gltf(const Path& file, const std::string& bytes) {
  LoadedMesh loaded{parse_gltf(file, bytes), {}};
  if (std::string note = weld(loaded.mesh); !note.empty()) loaded.notes.push_back(note);
  // Corners at one point are only seen now.
  for (std::size_t f = 0; f < loaded.mesh.polygons.size(); ++f) {
    check_polygon(file, "", f, loaded.mesh.polygons[f], loaded.mesh.positions.size(), 0);
  }
  return loaded;
}

const std::array<Format, 7> kFormats = {{
    {".obj",
     [](const Path& file, const std::string& bytes) {
       return LoadedMesh{openmesh_read("obj", check_obj(file, bytes)), {}};
     },
     [](const PolygonMesh& mesh) { return openmesh_write("obj", mesh); }, kAnyPolygon},
    {".off",
     [](const Path& file, const std::string& bytes) {
       return LoadedMesh{openmesh_read("off", check_off(file, bytes)), {}};
     },
     [](const PolygonMesh& mesh) { return openmesh_write("off", mesh); }, kAnyPolygon},
    {".ply",
     [](const Path& file, const std::string& bytes) {
       return LoadedMesh{openmesh_read("ply", check_ply(file, bytes)), {}};
     },
     [](const PolygonMesh& mesh) { return openmesh_write("ply", mesh); }, 255},
    {".stl", read_stl, [](const PolygonMesh& mesh) { return openmesh_write("stl", mesh); }, 3},
    {".gltf", read_gltf, [](const PolygonMesh& mesh) { return format_gltf(mesh, false); }, 3},
    {".glb", read_gltf, [](const PolygonMesh& mesh) { return format_gltf(mesh, true); }, 3},
    {".dae",
     [](const Path& file, const std::string& bytes) {
       return LoadedMesh{parse_collada(file, bytes), {}};
     },
     format_collada, kAnyPolygon},
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
    check_polygon(file, "", f, polygon, mesh.positions.size(), 0);
  }
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
  if (loaded.mesh.polygons.empty()) {
    refuse_file(file, "", "holds no faces; export the surface, not points or lines");
  }
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
