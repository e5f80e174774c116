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
  explicit CgalContestant(Task task) : task_(task) {}

  bool takes_part(Task task) const override { return task == task_; }

  void prepare(const Workload& workload) override { workload_ = &workload; }

  void build() override {
    for (const Point3& p : workload_->mesh.positions)
      mesh_.add_vertex(Point(p[0], p[1], p[2]));
    std::vector<Mesh::Vertex_index> face;
    for (const auto& corners : workload_->mesh.polygons) {
      face.clear();
      for (const std::uint32_t corner : corners)
        face.emplace_back(corner);
      mesh_.add_face(face);
    }
  }

  void subdivide() override {
    namespace method = CGAL::Subdivision_method_3;
    const auto once = CGAL::parameters::number_of_iterations(1);
    if (task_ == Task::kLoop) {
      method::Loop_subdivision(mesh_, once);
    } else {
      method::CatmullClark_subdivision(mesh_, once);
    }
  }

  std::size_t n_triangles() const override { return mesh_.number_of_faces(); }

 private:
  Task task_;
  const Workload* workload_ = nullptr;
  Mesh mesh_;
};

}  // namespace

std::unique_ptr<Contestant> make_cgal() {
  return std::make_unique<CgalContestant>(Task::kLoop);
}

std::unique_ptr<Contestant> make_cgal_catmull_clark() {
  return std::make_unique<CgalContestant>(Task::kCatmullClark);
}

}  // namespace meshgrade::bench
