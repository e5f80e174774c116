#include "grader/commands/mesh_info_command.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <optional>

#include "grader/files/bezier_file.h"
#include "grader/files/file_bytes.h"
#include "grader/files/mesh_file.h"
#include "grader/mesh/build_mesh.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using Edge = std::array<std::uint32_t, 2>;

constexpr std::size_t kMostComponentsListed = 8;

/// What can be counted in any bag of polygons, surface or not.
struct PolygonFacts {
  std::vector<Edge> edges;                  // lower end first, sorted, each once
  std::vector<std::uint32_t> component_of;  // of each vertex
  std::size_t n_components = 0;
};

std::vector<Edge> unique_edges(const PolygonMesh& mesh) {
  std::vector<Edge> edges;
  for (const auto& polygon : mesh.polygons) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::uint32_t a = polygon[k];
      const std::uint32_t b = polygon[(k + 1) % polygon.size()];
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

PolygonFacts gather_facts(const PolygonMesh& mesh) {
  PolygonFacts facts;
  facts.edges = unique_edges(mesh);
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&parent](std::uint32_t v) {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& [a, b] : facts.edges)
    parent[root(a)] = root(b);

  std::map<std::uint32_t, std::uint32_t> number_of_root;
  for (std::uint32_t v = 0; v < parent.size(); ++v) {
    const auto next = static_cast<std::uint32_t>(number_of_root.size());
    facts.component_of.push_back(number_of_root.try_emplace(root(v), next).first->second);
  }
  facts.n_components = number_of_root.size();
  return facts;
}

void print_row(const std::string& name, const std::string& value) {
  std::cout << "  " << name << std::string(12 - name.size(), ' ') << value << "\n";
}

template <typename Points>
void print_box(const Points& points) {
  auto low = points.front();
  auto high = low;
  for (const auto& point : points) {
    for (std::size_t axis = 0; axis < point.size(); ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  const auto words = [](const auto& point) {
    std::ostringstream text;
    text << '(' << point[0];
    for (std::size_t axis = 1; axis < point.size(); ++axis)
      text << ", " << point[axis];
    text << ')';
    return text.str();
  };
  print_row("box", words(low) + " to " + words(high));
}

/// "6 of valence 4, 1 of valence 5" for corners of faces, valences of vertices and the like.
std::string histogram(const std::map<std::size_t, std::size_t>& count_of,
                      const std::string& what) {
  std::string text;
  for (const auto& [value, count] : count_of) {
    if (!text.empty()) text += ", ";
    text += std::to_string(count) + " of " + what + " " + std::to_string(value);
  }
  return text;
}

std::string valences(const PolygonMesh& mesh, const PolygonFacts& facts) {
  std::vector<std::size_t> valence(mesh.positions.size(), 0);
  for (const auto& [a, b] : facts.edges) {
    ++valence[a];
    ++valence[b];
  }
  std::map<std::size_t, std::size_t> count_of;
  for (const std::size_t n : valence)
    ++count_of[n];
  return histogram(count_of, "valence");
}

std::string face_sizes(const PolygonMesh& mesh) {
  std::map<std::size_t, std::size_t> count_of;
  for (const auto& polygon : mesh.polygons)
    ++count_of[polygon.size()];
  const std::string total = std::to_string(mesh.polygons.size());
  if (count_of.size() == 1 && count_of.contains(3)) return total + ", all triangles";
  return total + ": " + histogram(count_of, "size");
}

/// Boundary loops of each component, from the half-edge mesh, which numbers vertices in the
/// order in which the polygons first name them.
std::vector<std::size_t> loops_of_components(const PolygonMesh& mesh, const PolygonFacts& facts,
                                             const meshedit::HalfedgeMesh& built) {
  std::vector<bool> seen(mesh.positions.size(), false);
  std::vector<std::uint32_t> file_vertex;
  for (const auto& polygon : mesh.polygons) {
    for (const std::uint32_t v : polygon) {
      if (!seen[v]) file_vertex.push_back(v);
      seen[v] = true;
    }
  }
  std::map<const void*, std::uint32_t> number_of;
  std::uint32_t next = 0;
  for (auto v = built.verticesBegin(); v != built.verticesEnd(); ++v) {
    number_of[meshedit::elementAddress(v)] = next++;
  }
  std::vector<std::size_t> loops(facts.n_components, 0);
  for (auto b = built.boundariesBegin(); b != built.boundariesEnd(); ++b) {
    const auto v = number_of.at(meshedit::elementAddress(b->halfedge()->vertex()));
    ++loops[facts.component_of[file_vertex[v]]];
  }
  return loops;
}

/// An orientable surface with b boundary loops has V - E + F = 2 - 2 genus - b.
void print_topology(const PolygonMesh& mesh, const PolygonFacts& facts,
                    const meshedit::HalfedgeMesh& built) {
  const std::vector<std::size_t> loops = loops_of_components(mesh, facts, built);
  std::vector<long> euler(facts.n_components, 0);
  for (const std::uint32_t c : facts.component_of)
    ++euler[c];
  for (const auto& [a, b] : facts.edges)
    --euler[facts.component_of[a]];
  for (const auto& polygon : mesh.polygons)
    ++euler[facts.component_of[polygon[0]]];

  const auto genus = [&](std::size_t c) {
    return (2 - euler[c] - static_cast<long>(loops[c])) / 2;
  };
  long total_genus = 0;
  for (std::size_t c = 0; c < facts.n_components; ++c)
    total_genus += genus(c);
  const auto n_loops = std::accumulate(loops.begin(), loops.end(), std::size_t{0});
  print_row("boundaries", std::to_string(n_loops) + (n_loops == 0 ? ", closed" : ""));
  print_row("genus", std::to_string(total_genus));
  if (facts.n_components == 1 || facts.n_components > kMostComponentsListed) return;
  for (std::size_t c = 0; c < facts.n_components; ++c) {
    print_row("", "component " + std::to_string(c) + ": genus " + std::to_string(genus(c)) +
                      ", boundaries " + std::to_string(loops[c]));
  }
}

int print_mesh(const fs::path& file) {
  const LoadedMesh loaded = read_mesh(file);
  const PolygonMesh& mesh = loaded.mesh;
  const PolygonFacts facts = gather_facts(mesh);
  const auto n_vertices = static_cast<long>(mesh.positions.size());
  const auto n_edges = static_cast<long>(facts.edges.size());
  const auto n_faces = static_cast<long>(mesh.polygons.size());
  std::cout << file.string() << "\n";
  print_row("vertices", std::to_string(n_vertices));
  print_row("edges", std::to_string(n_edges));
  print_row("faces", face_sizes(mesh));
  print_row("Euler", std::to_string(n_vertices - n_edges + n_faces));
  print_row("components", std::to_string(facts.n_components));

  std::string fault;
  meshedit::HalfedgeMesh built;
  try {
    build_mesh(mesh, built);
    print_topology(mesh, facts, built);
  } catch (const meshedit::MeshError& error) {
    fault = error.what();
  }
  print_row("valences", valences(mesh, facts));
  print_box(mesh.positions);
  for (const std::string& note : loaded.notes)
    print_row("note", note);
  if (fault.empty()) return 0;
  print_row("no surface", fault);
  return 2;
}

void print_patches(const fs::path& file) {
  const std::vector<ControlNet> patches = read_bez(file);
  std::map<std::string, std::size_t> count_of;
  std::vector<Point3> points;
  for (const ControlNet& net : patches) {
    ++count_of[std::to_string(net.rows) + " x " + std::to_string(net.cols)];
    points.insert(points.end(), net.points.begin(), net.points.end());
  }
  std::cout << file.string() << "\n";
  for (const auto& [size, count] : count_of) {
    print_row("patches", std::to_string(count) + " of " + size + " control points");
  }
  print_box(points);
}

void print_curve(const fs::path& file) {
  const std::vector<Point2> points = read_bzc(file);
  std::cout << file.string() << "\n";
  print_row("curve", std::to_string(points.size()) + " control points");
  print_box(points);
}

int print_info(const fs::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".bez") {
    print_patches(file);
  } else if (extension == ".bzc") {
    print_curve(file);
  } else {
    return print_mesh(file);
  }
  return 0;
}

}  // namespace

void add_mesh_info_command(CLI::App& app, int& exit_code) {
  auto file = std::make_shared<fs::path>();
  CLI::App* command = app.add_subcommand(
      "mesh-info", "Say what a mesh or Bezier file holds, and what is wrong");
  command->add_option("file", *file, "A mesh, or a .bez or .bzc file")->required();
  command->footer(
      "Examples:\n"
      "  meshgrade mesh-info meshes/double_torus.obj\n"
      "  meshgrade mesh-info meshes/teapot.bez\n"
      "  meshgrade mesh-info meshes/invalid/bow_tie.obj    (exit code 2: no surface)\n"
      "Exit code: 0, or 2 for bad usage, a file that cannot be read, or a mesh that is no "
      "surface.");
  command->callback([file, &exit_code] { exit_code = print_info(*file); });
}

}  // namespace meshgrade
