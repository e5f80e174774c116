#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include "tests/bench/contestant.h"

namespace meshgrade::bench {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

/// What PrimvarRefinerReal asks of a value that it interpolates.
struct RefinedPoint {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  void Clear() { *this = {}; }
  void AddWithWeight(const RefinedPoint& other, double weight) {
    x += weight * other.x;
    y += weight * other.y;
    z += weight * other.z;
  }
};

class OpenSubdivContestant : public Contestant {
 public:
  explicit OpenSubdivContestant(Task task) : task_(task) {}

  bool takes_part(Task task) const override { return task == task_; }

  void prepare(const Workload& workload) override {
    for (const auto& corners : workload.mesh.polygons) {
      sizes_.push_back(static_cast<int>(corners.size()));
      corners_.insert(corners_.end(), corners.begin(), corners.end());
    }
    for (const Point3& p : workload.mesh.positions)
      points_.push_back({p[0], p[1], p[2]});
  }

  void build() override {
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(points_.size());
    descriptor.numFaces = static_cast<int>(sizes_.size());
    descriptor.numVertsPerFace = sizes_.data();
    descriptor.vertIndicesPerFace = corners_.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    const auto scheme = task_ == Task::kLoop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
    refiner_.reset(Factory::Create(descriptor, Factory::Options(scheme, {})));
  }

  // With the neighbours of the last level, as the other libraries have them in the end.
  void subdivide() override {
    Far::TopologyRefiner::UniformOptions options(1);
    options.fullTopologyInLastLevel = true;
    refiner_->RefineUniform(options);
    refined_.resize(static_cast<std::size_t>(refiner_->GetLevel(1).GetNumVertices()));
    Far::PrimvarRefinerReal<double>(*refiner_).Interpolate(1, points_, refined_);
  }

  std::size_t n_triangles() const override {
    return static_cast<std::size_t>(refiner_->GetLevel(refiner_->GetMaxLevel()).GetNumFaces());
  }

 private:
  Task task_;
  std::unique_ptr<Far::TopologyRefiner> refiner_;
  std::vector<int> sizes_;
  std::vector<Far::Index> corners_;
  std::vector<RefinedPoint> points_;
  std::vector<RefinedPoint> refined_;
};

}  // namespace

std::unique_ptr<Contestant> make_opensubdiv() {
  return std::make_unique<OpenSubdivContestant>(Task::kLoop);
}

std::unique_ptr<Contestant> make_opensubdiv_catmull_clark() {
  return std::make_unique<OpenSubdivContestant>(Task::kCatmullClark);
}

}  // namespace meshgrade::bench
