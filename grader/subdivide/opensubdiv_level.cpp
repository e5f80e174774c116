#include "grader/subdivide/opensubdiv_level.h"

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

std::unique_ptr<Far::TopologyRefiner> refined_topology(const PolygonMesh& mesh,
                                                       Sdc::SchemeType scheme,
                                                       CornerRule corner_rule) {
  std::vector<int> sizes;
  std::vector<Far::Index> corners;
  for (const auto& polygon : mesh.polygons) {
    sizes.push_back(static_cast<int>(polygon.size()));
    for (const std::uint32_t v : polygon)
      corners.push_back(static_cast<Far::Index>(v));
  }
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
      Factory::Create(descriptor, Factory::Options(scheme, options)));
  if (!refiner) throw SubdivisionError("OpenSubdiv refuses the topology of this mesh");
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

void read_parents(const Far::TopologyLevel& old_level, SubdivisionLevel& result) {
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
                    const std::vector<Point3>& old_positions, SubdivisionLevel& result) {
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

SubdivisionLevel read_level(const Far::TopologyRefiner& refiner, const PolygonMesh& mesh) {
  const Far::TopologyLevel& new_level = refiner.GetLevel(1);
  SubdivisionLevel result;
  result.mesh.positions = refined_points(refiner, mesh.positions);
  result.mesh.polygons.reserve(static_cast<std::size_t>(new_level.GetNumFaces()));
  for (int f = 0; f < new_level.GetNumFaces(); ++f) {
    const Far::ConstIndexArray corners = new_level.GetFaceVertices(f);
    result.mesh.polygons.emplace_back(corners.begin(), corners.end());
  }
  read_parents(refiner.GetLevel(0), result);
  return result;
}

/// In levels of a scheme that has them: it must not be asked of others.
void read_middles(const Far::TopologyLevel& old_level, SubdivisionLevel& result) {
  for (int f = 0; f < old_level.GetNumFaces(); ++f)
    result.child_of_face.push_back(static_cast<std::uint32_t>(old_level.GetFaceChildVertex(f)));
}

}  // namespace

SubdivisionLevel opensubdiv_loop(const PolygonMesh& mesh, VertexRule vertex_rule,
                                 CornerRule corner_rule) {
  require_triangles(mesh);
  const auto refiner = refined_topology(mesh, Sdc::SCHEME_LOOP, corner_rule);
  SubdivisionLevel result = read_level(*refiner, mesh);
  if (vertex_rule == VertexRule::kWarren)
    move_to_warren(refiner->GetLevel(0), mesh.positions, result);
  return result;
}

SubdivisionLevel opensubdiv_catmull_clark(const PolygonMesh& mesh, CornerRule corner_rule) {
  const auto refiner = refined_topology(mesh, Sdc::SCHEME_CATMARK, corner_rule);
  SubdivisionLevel result = read_level(*refiner, mesh);
  read_middles(refiner->GetLevel(0), result);
  return result;
}

SubdivisionLevel opensubdiv_bilinear(const PolygonMesh& mesh) {
  const auto refiner = refined_topology(mesh, Sdc::SCHEME_BILINEAR, CornerRule::kSmooth);
  SubdivisionLevel result = read_level(*refiner, mesh);
  read_middles(refiner->GetLevel(0), result);
  return result;
}

}  // namespace meshgrade
