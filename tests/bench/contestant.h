#pragma once

// What every mesh library in the benchmark has to do. Written for C++17, like student code.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade::bench {

/// What the libraries work on.
struct Workload {
  PolygonMesh mesh;  ///< closed, of triangles; of quadrilaterals for Catmull-Clark
  /// Edges to flip or to split, each given as {face, k}: it joins corners k and k + 1. No two
  /// of them lie on the same face.
  std::vector<std::array<std::uint32_t, 2>> edges;
};

enum class Task { kBuild, kNormals, kFlips, kSplits, kLoop, kCatmullClark };

/// One mesh of one library. Its life is prepare(), build(), find_edges(), and then one task:
/// all of it as the library's users write it, and only the task is timed.
class Contestant {
 public:
  Contestant() = default;
  Contestant(const Contestant&) = delete;
  Contestant& operator=(const Contestant&) = delete;
  virtual ~Contestant() = default;

  virtual bool takes_part(Task task) const = 0;

  /// Brings the workload, which outlives the contestant, into the form that build() takes.
  virtual void prepare(const Workload& workload) = 0;
  virtual void build() = 0;
  /// Looks up the workload's edges.
  virtual void find_edges() {}

  /// Computes and keeps the normals of all vertices, weighted by area.
  virtual void compute_normals() {}
  virtual void flip_edges() {}
  /// Puts a vertex into the middle of each of the edges.
  virtual void split_edges() {}
  /// One level, of the scheme that it takes part in.
  virtual void subdivide() {}

  virtual std::size_t n_triangles() const = 0;
};

std::unique_ptr<Contestant> make_teaching_mesh();
std::unique_ptr<Contestant> make_unchecked_teaching_mesh();
std::unique_ptr<Contestant> make_list_mesh();
std::unique_ptr<Contestant> make_openmesh();
std::unique_ptr<Contestant> make_opensubdiv();
std::unique_ptr<Contestant> make_cgal();
/// What `meshgrade subdivide` runs.
std::unique_ptr<Contestant> make_direct_loop(unsigned threads);
/// The same three with Catmull-Clark.
std::unique_ptr<Contestant> make_opensubdiv_catmull_clark();
std::unique_ptr<Contestant> make_cgal_catmull_clark();
std::unique_ptr<Contestant> make_direct_catmull_clark();
/// No subdivision: copies as many bytes as direct Loop has for input and output.
std::unique_ptr<Contestant> make_copying_limit();

}  // namespace meshgrade::bench
