// The reference's functions on three meshes: the teaching mesh, the same without its checks,
// and a mesh of std::lists. CMakeLists.txt compiles this file and the reference's files once
// for each of them and gives `meshedit` another name each time, so that they stay apart.

#include "meshedit/meshedit.h"
#include "tests/bench/contestant.h"

namespace meshgrade::bench {
namespace {

class StudentContestant : public Contestant {
 public:
  bool takes_part(Task task) const override { return task != Task::kCatmullClark; }

  void prepare(const Workload& workload) override {
    chosen_ = workload.edges;
    for (const auto& corners : workload.mesh.polygons)
      polygons_.emplace_back(corners.begin(), corners.end());
    for (const Point3& p : workload.mesh.positions)
      positions_.emplace_back(p[0], p[1], p[2]);
  }

  void build() override { mesh_.build(polygons_, positions_); }

  // build() keeps the order of the faces and begins each at its first corner.
  void find_edges() override {
    std::vector<meshedit::FaceIter> faces;
    for (auto f = mesh_.facesBegin(); f != mesh_.facesEnd(); ++f)
      faces.push_back(f);
    for (const auto& [face, k] : chosen_) {
      meshedit::HalfedgeIter h = faces[face]->halfedge();
      for (std::uint32_t i = 0; i < k; ++i)
        h = h->next();
      edges_.push_back(h->edge());
    }
  }

  void compute_normals() override {
    normals_.reserve(mesh_.nVertices());
    for (auto v = mesh_.verticesBegin(); v != mesh_.verticesEnd(); ++v)
      normals_.push_back(v->normal());
  }

  void flip_edges() override {
    for (meshedit::EdgeIter e : edges_)
      mesh_.flipEdge(e);
  }

  void split_edges() override {
    for (meshedit::EdgeIter e : edges_)
      mesh_.splitEdge(e);
  }

  void subdivide() override { meshedit::MeshResampler().upsample(mesh_); }

  std::size_t n_triangles() const override { return mesh_.nFaces(); }

 private:
  meshedit::HalfedgeMesh mesh_;
  std::vector<std::vector<meshedit::Index>> polygons_;
  std::vector<meshedit::Vector3D> positions_;
  std::vector<std::array<std::uint32_t, 2>> chosen_;
  std::vector<meshedit::EdgeIter> edges_;
  std::vector<meshedit::Vector3D> normals_;
};

}  // namespace

std::unique_ptr<Contestant> MESHGRADE_BENCH_FACTORY() {
  return std::make_unique<StudentContestant>();
}

}  // namespace meshgrade::bench
