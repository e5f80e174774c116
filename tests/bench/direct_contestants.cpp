#include <cstring>

#include "grader/subdivide/direct_catmull_clark.h"
#include "grader/subdivide/direct_loop.h"
#include "tests/bench/contestant.h"

namespace meshgrade::bench {
namespace {

template <class Surface, Task kTask>
class DirectContestant : public Contestant {
 public:
  explicit DirectContestant(unsigned threads) { options_.threads = threads; }

  bool takes_part(Task task) const override { return task == kTask; }
  void prepare(const Workload& workload) override { workload_ = &workload; }
  void build() override { surface_ = std::make_unique<Surface>(workload_->mesh); }
  void subdivide() override { surface_->subdivide(options_); }
  std::size_t n_triangles() const override { return surface_->n_faces(); }

 private:
  SubdivisionOptions options_;
  const Workload* workload_ = nullptr;
  std::unique_ptr<Surface> surface_;
};

/// As many bytes as DirectLoop keeps for a closed mesh, before and after one level.
class CopyingLimit : public Contestant {
 public:
  bool takes_part(Task task) const override { return task == Task::kLoop; }

  void prepare(const Workload& workload) override {
    n_triangles_ = workload.mesh.polygons.size();
    for (const std::size_t n_faces : {n_triangles_, 4 * n_triangles_}) {
      const std::size_t n_vertices = n_faces / 2 + 2;
      sizes_[n_faces == n_triangles_ ? 0 : 1] =
          n_vertices * sizeof(Point3) + 2 * 3 * n_faces * sizeof(std::uint32_t);
    }
  }

  void build() override {
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      originals_[i] = make_big_array<char>(sizes_[i]);
      std::memset(originals_[i].get(), 1, sizes_[i]);
    }
  }

  void subdivide() override {
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      copies_[i] = make_big_array<char>(sizes_[i]);
      std::memcpy(copies_[i].get(), originals_[i].get(), sizes_[i]);
    }
    n_triangles_ *= 4;
  }

  std::size_t n_triangles() const override { return n_triangles_; }

 private:
  std::size_t n_triangles_ = 0;
  std::array<std::size_t, 2> sizes_{};
  std::array<BigArray<char>, 2> originals_;
  std::array<BigArray<char>, 2> copies_;
};

}  // namespace

std::unique_ptr<Contestant> make_direct_loop(unsigned threads) {
  return std::make_unique<DirectContestant<DirectLoop, Task::kLoop>>(threads);
}

std::unique_ptr<Contestant> make_direct_catmull_clark() {
  return std::make_unique<DirectContestant<DirectCatmullClark, Task::kCatmullClark>>(1);
}

std::unique_ptr<Contestant> make_copying_limit() {
  return std::make_unique<CopyingLimit>();
}

}  // namespace meshgrade::bench
