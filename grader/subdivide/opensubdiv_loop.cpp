#include "grader/subdivide/opensubdiv_loop.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <memory>
#include <string>

namespace meshgrade {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

/// What PrimvarRefinerReal asks of a value that it interpolates.
struct RefinedPoint {
  Point3 at{};

  void Clear() { at = {}; }
  void AddWithWeight(const RefinedPoint& other, double weight) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      at[axis] += weight * other.at[axis];
  }
};

std::vector<Far::Index> flat_corners(const PolygonMesh& mesh) {
  std::vector<Far::Index> corners;
  corners.reserve(mesh.polygons.size() * 3);
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    const auto& polygon = mesh.polygons[f];
    if (polygon.size() != 3) {
      throw LoopError("face f" + std::to_string(f) + " has " + std::to_string(polygon.size()) +
                      " corners: Loop subdivision needs triangles");
    }
    for (const std::uint32_t v : polygon)
      corners.push_back(static_cast<Far::Index>(v));
  }
  return corners;
}

std::unique_ptr<Far::TopologyRefiner> refined_topology(const PolygonMesh& mesh,
                                                       CornerRule corner_rule) {
  const std::vector<Far::Index> corners = flat_corners(mesh);
  const std::vector<int> sizes(mesh.polygons.size(), 3);
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(mesh.positions.size());
  descriptor.numFaces = static_cast<int>(mesh.polygons.size());
  descriptor.numVertsPerFace = sizes.data();
  descriptor.vertIndicesPerFace = corners.data();

  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(corner_rule == CornerRule::kCorner
                                          ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                          : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  std::unique_ptr<Far::TopologyRefiner> refiner(
      Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_LOOP, options)));
  if (!refiner) throw LoopError("OpenSubdiv refuses the topology of this mesh");
  Far::TopologyRefiner::UniformOptions uniform(1);
  uniform.orderVerticesFromFacesFirst = false;
  uniform.fullTopologyInLastLevel = true;
  refiner->RefineUniform(uniform);
  return refiner;
}

std::vector<Point3> refined_points(const Far::TopologyRefiner& refiner,
                                   const std::vector<Point3>& old_positions) {
  std::vector<RefinedPoint> from(old_positions.size());
  for (std::size_t v = 0; v < from.size(); ++v)
    from[v].at = old_positions[v];
  std::vector<RefinedPoint> to(static_cast<std::size_t>(refiner.GetLevel(1).GetNumVertices()));
  const Far::PrimvarRefinerReal<double> primvars(refiner);
  primvars.Interpolate(1, from, to);

  std::vector<Point3> points;
  points.reserve(to.size());
  for (const RefinedPoint& point : to)
    points.push_back(point.at);
  return points;
}

void read_parents(const Far::TopologyLevel& old_level, LoopLevel& result) {
  for (int v = 0; v < old_level.GetNumVertices(); ++v) {
    result.child_of_vertex.push_back(
        static_cast<std::uint32_t>(old_level.GetVertexChildVertex(v)));
  }
  for (int e = 0; e < old_level.GetNumEdges(); ++e) {
    const Far::ConstIndexArray ends = old_level.GetEdgeVertices(e);
    result.edges.push_back(
        {static_cast<std::uint32_t>(ends[0]), static_cast<std::uint32_t>(ends[1])});
    result.child_of_edge.push_back(static_cast<std::uint32_t>(old_level.GetEdgeChildVertex(e)));
  }
}

void move_to_warren(const Far::TopologyLevel& old_level,
                    const std::vector<Point3>& old_positions, LoopLevel& result) {
  for (int v = 0; v < old_level.GetNumVertices(); ++v) {
    if (old_level.IsVertexBoundary(v) || old_level.IsVertexNonManifold(v)) continue;
    const auto valence = static_cast<std::size_t>(old_level.GetVertexEdges(v).size());
    const double ratio = neighbour_weight(VertexRule::kWarren, valence) /
                         neighbour_weight(VertexRule::kLoop, valence);
    const Point3& before = old_positions[static_cast<std::size_t>(v)];
    Point3& after = result.mesh.positions[result.child_of_vertex[static_cast<std::size_t>(v)]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      after[axis] = before[axis] + ratio * (after[axis] - before[axis]);
    }
  }
}

}  // namespace

LoopLevel opensubdiv_loop(const PolygonMesh& mesh, VertexRule vertex_rule,
                          CornerRule corner_rule) {
  const auto refiner = refined_topology(mesh, corner_rule);
  const Far::TopologyLevel& old_level = refiner->GetLevel(0);
  const Far::TopologyLevel& new_level = refiner->GetLevel(1);

  LoopLevel result;
  result.mesh.positions = refined_points(*refiner, mesh.positions);
  result.mesh.polygons.reserve(static_cast<std::size_t>(new_level.GetNumFaces()));
  for (int f = 0; f < new_level.GetNumFaces(); ++f) {
    const Far::ConstIndexArray corners = new_level.GetFaceVertices(f);
    result.mesh.polygons.emplace_back(corners.begin(), corners.end());
  }
  read_parents(old_level, result);
  if (vertex_rule == VertexRule::kWarren) move_to_warren(old_level, mesh.positions, result);
  return result;
}

}  // namespace meshgrade
