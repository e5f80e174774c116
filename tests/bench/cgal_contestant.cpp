#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include "tests/bench/contestant.h"

namespace meshgrade::bench {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

class CgalContestant : public Contestant {
 public:
  bool takes_part(Task task) const override { return task == Task::kLoop; }

  void prepare(const Workload& workload) override { workload_ = &workload; }

  void build() override {
    for (const Point3& p : workload_->mesh.positions)
      mesh_.add_vertex(Point(p[0], p[1], p[2]));
    for (const auto& corners : workload_->mesh.polygons) {
      mesh_.add_face(Mesh::Vertex_index(corners[0]), Mesh::Vertex_index(corners[1]),
                     Mesh::Vertex_index(corners[2]));
    }
  }

  void subdivide() override {
    CGAL::Subdivision_method_3::Loop_subdivision(mesh_,
                                                 CGAL::parameters::number_of_iterations(1));
  }

  std::size_t n_triangles() const override { return mesh_.number_of_faces(); }

 private:
  const Workload* workload_ = nullptr;
  Mesh mesh_;
};

}  // namespace

std::unique_ptr<Contestant> make_cgal() {
  return std::make_unique<CgalContestant>();
}

}  // namespace meshgrade::bench
