#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/files/mesh_file.h"

namespace meshgrade {

/// A test with a folder of its own, which is gone afterwards.
class FilesTest : public testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path(name), std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path(name);
  }

  ScratchFolder folder_;
};

/// The least and the largest corner of the box around the vertices.
inline std::array<Point3, 2> box_of(const PolygonMesh& mesh) {
  std::array<Point3, 2> box = {mesh.positions.at(0), mesh.positions.at(0)};
  for (const Point3& point : mesh.positions) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box[0][axis] = std::min(box[0][axis], point[axis]);
      box[1][axis] = std::max(box[1][axis], point[axis]);
    }
  }
  return box;
}

/// Four faces on four vertices from (0 0 0) to (1 1 1), each edge run once in each direction,
/// and nothing else said than `notes`.
inline void expect_tetrahedron(const LoadedMesh& loaded,
                               const std::vector<std::string>& notes = {}) {
  EXPECT_EQ(loaded.mesh.positions.size(), 4U);
  ASSERT_EQ(loaded.mesh.polygons.size(), 4U);
  EXPECT_EQ(box_of(loaded.mesh), (std::array<Point3, 2>{{{0, 0, 0}, {1, 1, 1}}}));
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& polygon : loaded.mesh.polygons) {
    ASSERT_EQ(polygon.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k)
      edges.emplace(polygon[k], polygon[(k + 1) % 3]);
  }
  EXPECT_EQ(edges.size(), 12U);
  EXPECT_EQ(loaded.notes, notes);
}

/// What reading says about a broken file, without the folder; empty if it is taken.
inline std::string fault_of(const std::filesystem::path& file) {
  try {
    read_mesh(file);
  } catch (const UserError& error) {
    const std::string message = error.what();
    const std::size_t name =
        message.rfind(file.string(), 0) == 0 ? file.parent_path().string().size() + 1 : 0;
    return message.substr(name);
  }
  return "";
}

}  // namespace meshgrade
