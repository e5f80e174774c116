// A large mesh reaches the page as bytes, and they say what the JSON would.

#include "grader/view/page_answer.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "grader/report/mesh_json.h"
#include "tests/view/student_folder.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

/// A grid of n x n squares, each of two triangles: 2 n^2 faces.
PolygonMesh grid_of(std::uint32_t n) {
  PolygonMesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x)
      mesh.positions.push_back({x / 3.0, y / 7.0, 0.1 * x * y});
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      mesh.polygons.push_back({a, a + 1, a + n + 2});
      mesh.polygons.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return mesh;
}

/// The diagonal of the square in the middle of a grid.
Ref middle_diagonal(const MeshDump& mesh, std::uint32_t n) {
  const Point3 from{(n / 2) / 3.0, (n / 2) / 7.0, 0.1 * (n / 2) * (n / 2)};
  const Point3 to{(n / 2 + 1) / 3.0, (n / 2 + 1) / 7.0, 0.1 * (n / 2 + 1) * (n / 2 + 1)};
  for (const HalfedgeRecord& h : mesh.halfedges) {
    const HalfedgeRecord& next = mesh.halfedges[h.next];
    if (mesh.vertices[h.vertex].position == from && mesh.vertices[next.vertex].position == to) {
      return h.edge;
    }
  }
  ADD_FAILURE() << "the grid has no such edge";
  return kUnsetRef;
}

template <class Number>
Json numbers(const std::string& body, std::size_t& at, std::size_t count) {
  Json list = Json::array();
  for (std::size_t i = 0; i < count; ++i, at += sizeof(Number)) {
    Number number{};
    std::memcpy(&number, &body.at(at + sizeof number - 1) - (sizeof number - 1), sizeof number);
    list.push_back(number);
  }
  return list;
}

struct Unpacked {
  Json json;
  std::string arrays;
};

Unpacked unpack(const PageAnswer& answer) {
  EXPECT_STREQ(answer.type, "application/octet-stream");
  EXPECT_EQ(answer.body.substr(0, 4), "MGM1");
  std::size_t at = 4;
  const std::size_t size = numbers<std::uint32_t>(answer.body, at, 1)[0];
  EXPECT_EQ(size % 8, 0U);
  return {Json::parse(answer.body.substr(8, size)), answer.body.substr(8 + size)};
}

/// A mesh as the page reads it from the arrays.
Json mesh_from(const Unpacked& answer, const Json& sizes) {
  std::size_t at = sizes["at"];
  EXPECT_EQ(at % 8, 0U);
  Json p = numbers<double>(answer.arrays, at, 3 * sizes["v"].get<std::size_t>());
  Json mesh;
  for (const auto& [kind, width] : {std::pair{"h", 6}, std::pair{"v", 2}, std::pair{"e", 2},
                                    std::pair{"f", 3}, std::pair{"b", 3}}) {
    mesh[kind] =
        numbers<std::uint32_t>(answer.arrays, at, width * sizes[kind].get<std::size_t>());
    if (kind == std::string("v")) mesh["p"] = std::move(p);
  }
  return mesh;
}

TEST(PageAnswer, SmallMeshIsJson) {
  const Student student({"edge_flip.cpp"});
  const PageAnswer answer = answer_for_page(*student.session);
  EXPECT_STREQ(answer.type, "application/json");
  EXPECT_EQ(Json::parse(answer.body)["state"]["mesh"], to_json_value(student.mesh()));
}

TEST(PageAnswer, LargeMeshIsBytesThatSayTheSameAlsoAfterAStep) {
  Student student({"edge_flip.cpp"});
  student.session->open("grid", grid_of(104));
  ASSERT_GT(student.mesh().halfedges.size(), kMostHalfedgesAsJson);
  const Unpacked start = unpack(answer_for_page(*student.session));
  EXPECT_EQ(mesh_from(start, start.json["state"]["mesh"]), to_json_value(student.mesh()));

  student.session->apply(
      {"edge_flip", ElementKind::kEdge, {middle_diagonal(student.mesh(), 104)}});
  const Unpacked flipped = unpack(answer_for_page(*student.session));
  EXPECT_EQ(flipped.json["state"]["told"]["verdict"], "passed");
  EXPECT_EQ(mesh_from(flipped, flipped.json["state"]["before"]),
            to_json_value(student.session->states()[0].mesh));
  EXPECT_EQ(mesh_from(flipped, flipped.json["state"]["mesh"]), to_json_value(student.mesh()));
}

TEST(PageAnswer, LargeMeshThatWasLeftHalfDoneComesToo) {
  Student student({}, "cube.obj", "edge_flip.cpp",
                  flip_file("e0->halfedge()->next() = e0->halfedge();\n"
                            "return HalfedgeIter()->edge();"));
  student.session->open("grid", grid_of(104));
  student.session->apply(
      {"edge_flip", ElementKind::kEdge, {middle_diagonal(student.mesh(), 104)}});
  ASSERT_TRUE(student.session->stopped());
  ASSERT_TRUE(student.session->stopped()->mesh);
  const Unpacked answer = unpack(answer_for_page(*student.session));
  const Json left = mesh_from(answer, answer.json["stopped"]["mesh"]);
  EXPECT_EQ(left, to_json_value(*student.session->stopped()->mesh));
  EXPECT_NE(left, mesh_from(answer, answer.json["state"]["mesh"]));
}

}  // namespace
}  // namespace meshgrade
