#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

#include "tests/bench/contestant.h"

namespace meshgrade::bench {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

class OpenMeshContestant : public Contestant {
 public:
  bool takes_part(Task task) const override { return task != Task::kCatmullClark; }

  void prepare(const Workload& workload) override { workload_ = &workload; }

  void build() override {
    const PolygonMesh& input = workload_->mesh;
    const std::size_t n_vertices = input.positions.size();
    const std::size_t n_faces = input.polygons.size();
    mesh_.reserve(n_vertices, n_faces * 3 / 2, n_faces);
    for (const Point3& p : input.positions)
      mesh_.add_vertex(Mesh::Point(p[0], p[1], p[2]));
    for (const auto& corners : input.polygons) {
      mesh_.add_face(vertex(corners[0]), vertex(corners[1]), vertex(corners[2]));
    }
  }

  void find_edges() override {
    for (const auto& [face, k] : workload_->edges) {
      const auto& corners = workload_->mesh.polygons[face];
      const auto h = mesh_.find_halfedge(vertex(corners[k]), vertex(corners[(k + 1) % 3]));
      edges_.push_back(mesh_.edge_handle(h));
    }
  }

  void compute_normals() override {
    normals_.reserve(mesh_.n_vertices());
    for (const auto v : mesh_.vertices()) {
      Mesh::Normal normal;
      mesh_.calc_vertex_normal_correct(v, normal);
      normals_.push_back(normal.normalize());
    }
  }

  void flip_edges() override {
    for (const Mesh::EdgeHandle e : edges_) {
      if (!mesh_.is_boundary(e)) mesh_.flip(e);
    }
  }

  void split_edges() override {
    for (const Mesh::EdgeHandle e : edges_)
      mesh_.split(e, mesh_.calc_edge_midpoint(e));
  }

  void subdivide() override {
    OpenMesh::Subdivider::Uniform::LoopT<Mesh, double> loop;
    loop.attach(mesh_);
    loop(1);
    loop.detach();
  }

  std::size_t n_triangles() const override { return mesh_.n_faces(); }

 private:
  static Mesh::VertexHandle vertex(std::uint32_t index) {
    return Mesh::VertexHandle(static_cast<int>(index));
  }

  const Workload* workload_ = nullptr;
  Mesh mesh_;
  std::vector<Mesh::EdgeHandle> edges_;
  std::vector<Mesh::Normal> normals_;
};

}  // namespace

std::unique_ptr<Contestant> make_openmesh() {
  return std::make_unique<OpenMeshContestant>();
}

}  // namespace meshgrade::bench
