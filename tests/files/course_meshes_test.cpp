// Every file in meshes/ is what meshes/README.md says it is.

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "grader/files/bezier_file.h"
#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

const fs::path kMeshFolder = MESHGRADE_SOURCE_DIR "/meshes";

/// The rows of the README's tables whose first cell is a file name in backquotes.
std::map<std::string, std::vector<std::string>> readme_rows() {
  std::map<std::string, std::vector<std::string>> rows;
  std::ifstream readme(kMeshFolder / "README.md");
  for (std::string line; std::getline(readme, line);) {
    if (!line.starts_with("| `")) continue;
    const std::size_t end = line.find('`', 3);
    std::istringstream cells(line.substr(line.find('|', end) + 1));
    auto& row = rows[line.substr(3, end - 3)];
    for (std::string cell; std::getline(cells, cell, '|');) {
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
      row.push_back(cell);
    }
  }
  return rows;
}

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && name != "README.md") names.insert(name);
  }
  return names;
}

/// How often each edge is run, forwards (lower to higher vertex) and backwards.
using EdgeUse = std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>>;

EdgeUse edge_use(const PolygonMesh& mesh) {
  EdgeUse use;
  for (const auto& polygon : mesh.polygons) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::uint32_t a = polygon[k];
      const std::uint32_t b = polygon[(k + 1) % polygon.size()];
      auto& [forwards, backwards] = use[{std::min(a, b), std::max(a, b)}];
      ++(a < b ? forwards : backwards);
    }
  }
  return use;
}

/// Six times the volume that a closed mesh encloses; positive if it is wound outward.
double enclosed_volume(const PolygonMesh& mesh) {
  double volume = 0;
  for (const auto& polygon : mesh.polygons) {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      const Point3& a = mesh.positions[polygon[0]];
      const Point3& b = mesh.positions[polygon[k]];
      const Point3& c = mesh.positions[polygon[k + 1]];
      volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  }
  return volume;
}

void expect_row(const std::string& name, const std::vector<std::string>& row) {
  SCOPED_TRACE(name);
  const PolygonMesh mesh = read_mesh(kMeshFolder / name).mesh;
  const EdgeUse use = edge_use(mesh);
  EXPECT_EQ(std::to_string(mesh.positions.size()), row.at(0));
  EXPECT_EQ(std::to_string(use.size()), row.at(1));
  EXPECT_EQ(std::to_string(mesh.polygons.size()), row.at(2));
  const bool is_closed = std::all_of(
      use.begin(), use.end(), [](const auto& edge) { return edge.second == std::pair(1, 1); });
  EXPECT_EQ(is_closed ? "yes" : "no", row.at(3));
  for (const auto& [edge, times] : use) {
    EXPECT_TRUE(times.first <= 1 && times.second <= 1) << edge.first << "-" << edge.second;
  }
  if (is_closed) {
    EXPECT_GT(enclosed_volume(mesh), 0);
  }
}

void expect_control_points(const std::string& name, const std::string& promised) {
  SCOPED_TRACE(name);
  if (name.ends_with(".bzc")) {
    EXPECT_EQ(std::to_string(read_bzc(kMeshFolder / name).size()), promised);
    return;
  }
  const std::vector<ControlNet> patches = read_bez(kMeshFolder / name);
  const std::string size =
      std::to_string(patches[0].rows) + " x " + std::to_string(patches[0].cols);
  const std::string prefix =
      patches.size() > 1 ? std::to_string(patches.size()) + " of " : std::string();
  EXPECT_EQ(prefix + size, promised);
}

TEST(CourseMeshes, AreWhatTheReadmePromises) {
  const auto rows = readme_rows();
  for (const std::string& name : files_in(kMeshFolder)) {
    const auto row = rows.find(name);
    ASSERT_NE(row, rows.end()) << name << " has no row in meshes/README.md";
    if (name.ends_with(".bez") || name.ends_with(".bzc")) {
      expect_control_points(name, row->second.at(0));
    } else {
      expect_row(name, row->second);
    }
  }
}

TEST(CourseMeshes, ReadmeNamesNoFileThatIsNotThere) {
  std::set<std::string> files = files_in(kMeshFolder);
  files.merge(files_in(kMeshFolder / "invalid"));
  for (const auto& [name, row] : readme_rows())
    EXPECT_TRUE(files.contains(name)) << name;
}

TEST(CourseMeshes, ValenceZooHasEveryValenceFromThreeToTwelve) {
  std::map<std::uint32_t, int> valence;
  for (const auto& [edge, times] : edge_use(read_mesh(kMeshFolder / "valence_zoo.obj").mesh)) {
    ++valence[edge.first];
    ++valence[edge.second];
  }
  std::set<int> valences;
  for (const auto& [vertex, n] : valence)
    valences.insert(n);
  EXPECT_EQ(valences, (std::set<int>{3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
}

TEST(InvalidMeshes, AreRefusedInOneLineOrArriveWithAllTheirFacesOrANote) {
  const auto rows = readme_rows();
  for (const std::string& name : files_in(kMeshFolder / "invalid")) {
    SCOPED_TRACE(name);
    const fs::path file = kMeshFolder / "invalid" / name;
    ASSERT_TRUE(rows.contains(name));
    if (rows.at(name).at(0) == "surface") {
      std::ifstream text(file);
      std::size_t n_faces = 0;
      for (std::string line; std::getline(text, line);)
        n_faces += line.starts_with("f ");
      EXPECT_EQ(read_mesh(file).mesh.polygons.size(), n_faces);
      continue;
    }
    if (rows.at(name).at(0) == "nothing") {
      EXPECT_EQ(read_mesh(file).notes.size(), 1U);
      continue;
    }
    std::string message;
    try {
      if (name.ends_with(".bez")) {
        read_bez(file);
      } else if (name.ends_with(".bzc")) {
        read_bzc(file);
      } else {
        read_mesh(file);
      }
    } catch (const UserError& error) {
      message = error.what();
    }
    EXPECT_TRUE(message.starts_with(file.string() + ":")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace meshgrade
