#include "grader/files/openmesh_files.h"

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/exporter/ExporterT.hh>
#include <OpenMesh/Core/IO/importer/ImporterT.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cmath>
#include <limits>
#include <mutex>
#include <sstream>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

namespace IO = OpenMesh::IO;
using OpenMesh::FaceHandle;
using OpenMesh::Vec3d;
using OpenMesh::Vec3f;
using OpenMesh::VertexHandle;
using NoMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

/// OpenMesh's readers and writers are singletons that keep state while they work.
std::mutex& openmesh_mutex() {
  static std::mutex mutex;
  return mutex;
}

void silence_openmesh() {
  omlog().disable();
  omout().disable();
  omerr().disable();
}

/// Collects vertices and polygons; everything else goes to an empty mesh that nobody reads.
class PolygonImporter : public IO::ImporterT<NoMesh> {
 public:
  explicit PolygonImporter(NoMesh& no_mesh) : ImporterT(no_mesh) {}

  using ImporterT::add_face;
  VertexHandle add_vertex() override { return add_vertex(Vec3d(0, 0, 0)); }
  VertexHandle add_vertex(const Vec3f& point) override {
    return add_vertex(Vec3d(point[0], point[1], point[2]));
  }
  VertexHandle add_vertex(const Vec3d& point) override {
    mesh.positions.push_back({point[0], point[1], point[2]});
    return VertexHandle(static_cast<int>(mesh.positions.size()) - 1);
  }
  void set_point(VertexHandle vertex, const Vec3f& point) override {
    mesh.positions.at(static_cast<std::size_t>(vertex.idx())) = {point[0], point[1], point[2]};
  }
  FaceHandle add_face(const VHandles& corners) override {
    auto& polygon = mesh.polygons.emplace_back();
    for (const VertexHandle v : corners)
      polygon.push_back(static_cast<std::uint32_t>(v.idx()));
    return FaceHandle(static_cast<int>(mesh.polygons.size()) - 1);
  }
  // OpenMesh's OBJ reader calls these for every face, textured or not.
  using TexCoords2 = std::vector<OpenMesh::Vec2f>;
  using TexCoords3 = std::vector<Vec3f>;
  void add_face_texcoords(FaceHandle, VertexHandle, const TexCoords2&) override {}
  void add_face_texcoords(FaceHandle, VertexHandle, const TexCoords3&) override {}
  std::size_t n_vertices() const override { return mesh.positions.size(); }
  std::size_t n_faces() const override { return mesh.polygons.size(); }

  PolygonMesh mesh;
};

Vec3f as_float(const Point3& point) {
  return {static_cast<float>(point[0]), static_cast<float>(point[1]),
          static_cast<float>(point[2])};
}

/// Shows the polygons to OpenMesh's writers; everything else comes from an empty mesh.
class PolygonExporter : public IO::ExporterT<NoMesh> {
 public:
  PolygonExporter(const PolygonMesh& mesh, NoMesh& no_mesh)
      : ExporterT(no_mesh), mesh_(mesh), no_mesh_(no_mesh) {}

  Vec3f point(VertexHandle v) const override {
    return as_float(mesh_.positions[static_cast<std::size_t>(v.idx())]);
  }
  unsigned int get_vhandles(FaceHandle f, std::vector<VertexHandle>& corners) const override {
    corners.clear();
    for (const std::uint32_t v : mesh_.polygons[static_cast<std::size_t>(f.idx())]) {
      corners.emplace_back(static_cast<int>(v));
    }
    return static_cast<unsigned int>(corners.size());
  }
  /// For STL. OpenMesh's own would be NaN for a face without area.
  bool has_face_normals() const override { return true; }
  using ExporterT::normal;
  Vec3f normal(FaceHandle f) const override {
    const auto& polygon = mesh_.polygons[static_cast<std::size_t>(f.idx())];
    const Vec3f a = as_float(mesh_.positions[polygon[0]]);
    const Vec3f b = as_float(mesh_.positions[polygon[1]]);
    const Vec3f c = as_float(mesh_.positions[polygon[2]]);
    const Vec3f across = (b - a) % (c - a);
    const float length = across.norm();
    return length > 0 && std::isfinite(length) ? across / length : Vec3f(0, 0, 0);
  }
  std::size_t n_vertices() const override { return mesh_.positions.size(); }
  std::size_t n_faces() const override { return mesh_.polygons.size(); }
  const OpenMesh::BaseKernel* kernel() override { return &no_mesh_; }

 private:
  const PolygonMesh& mesh_;
  NoMesh& no_mesh_;
};

}  // namespace

PolygonMesh openmesh_read(const std::string& format, const CheckedInput& input) {
  const std::lock_guard lock(openmesh_mutex());
  silence_openmesh();
  NoMesh no_mesh;
  PolygonImporter importer(no_mesh);
  std::istringstream stream(input.bytes);
  IO::Options options = input.is_binary ? IO::Options::Binary : IO::Options::Default;
  const bool ok = IO::IOManager().read(stream, format, importer, options);
  const bool all_vertices =
      input.exact_positions.empty() || input.exact_positions.size() == importer.n_vertices();
  if (!ok || importer.n_faces() != input.n_faces || !all_vertices) {
    throw GraderError("OpenMesh read " + std::to_string(importer.n_faces()) + " of " +
                      std::to_string(input.n_faces) + " faces of a checked " + format +
                      " file");
  }
  if (!input.exact_positions.empty()) importer.mesh.positions = input.exact_positions;
  return std::move(importer.mesh);
}

std::string openmesh_write(const std::string& format, const PolygonMesh& mesh) {
  const std::lock_guard lock(openmesh_mutex());
  silence_openmesh();
  NoMesh no_mesh;
  PolygonExporter exporter(mesh, no_mesh);
  std::ostringstream stream;
  const bool is_binary = format == "ply" || format == "stl";
  const IO::Options options = is_binary ? IO::Options::Binary : IO::Options::Default;
  if (!IO::IOManager().write(stream, format, exporter, options,
                             std::numeric_limits<float>::max_digits10)) {
    throw GraderError("OpenMesh cannot write this mesh as " + format);
  }
  return std::move(stream).str();
}

}  // namespace meshgrade
