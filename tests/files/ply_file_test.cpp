// In a PLY text each element is a line, and the header sets the order of everything.

#include <gmock/gmock.h>

#include <cstring>

#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kVertexElement =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFaceElement = "element face 4\nproperty list uchar int vertex_indices\n";
const std::string kVertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string kFaces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

class PlyFile : public FilesTest {
 protected:
  static std::string text(const std::string& elements, const std::string& body) {
    return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
  }
  LoadedMesh read(const std::string& elements, const std::string& body) const {
    return read_mesh(write("a.ply", text(elements, body)));
  }
  std::string fault(const std::string& elements, const std::string& body) const {
    return fault_of(write("a.ply", text(elements, body)));
  }
};

/// Appends numbers as little-endian bytes.
class Bytes {
 public:
  template <typename Number>
  Bytes& put(std::initializer_list<double> numbers) {
    for (const double number : numbers) {
      const auto value = static_cast<Number>(number);
      char raw[sizeof(value)];
      std::memcpy(raw, &value, sizeof(value));
      bytes_.append(raw, sizeof(value));
    }
    return *this;
  }
  const std::string& get() const { return bytes_; }

 private:
  std::string bytes_;
};

std::string binary_vertices() {
  return Bytes().put<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}).get();
}

std::string binary_faces() {
  Bytes bytes;
  for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    bytes.put<std::uint8_t>({3});
    for (const int v : face)
      bytes.put<std::int32_t>({static_cast<double>(v)});
  }
  return bytes.get();
}

TEST_F(PlyFile, TheHeaderSetsTheOrderOfTheElements) {
  expect_tetrahedron(read(kVertexElement + kFaceElement, kVertices + kFaces));
  expect_tetrahedron(read(kFaceElement + kVertexElement, kFaces + kVertices));
  const std::string head = "ply\ncomment first\nformat binary_little_endian 1.0\n";
  for (const bool faces_first : {false, true}) {
    const std::string elements =
        faces_first ? kFaceElement + kVertexElement : kVertexElement + kFaceElement;
    const std::string body =
        faces_first ? binary_faces() + binary_vertices() : binary_vertices() + binary_faces();
    expect_tetrahedron(read_mesh(write("a.ply", head + elements + "end_header\n" + body)));
  }
}

TEST_F(PlyFile, DataThatBeginWithALineFeedAreNotPartOfTheHeader) {
  // 10 is a line feed, and the lowest byte of the first index.
  std::string header =
      "ply\nformat binary_little_endian 1.0\nelement face 1\n"
      "property int id\nproperty list uchar int vertex_indices\n" +
      kVertexElement + "end_header\n";
  const std::string body = Bytes()
                               .put<std::int32_t>({10})
                               .put<std::uint8_t>({3})
                               .put<std::int32_t>({0, 1, 2})
                               .get() +
                           binary_vertices();
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string ended = header;
    for (std::size_t at = ended.find('\n'); at != ended.npos;
         at = ended.find('\n', at + end.size()))
      ended.replace(at, 1, end);
    EXPECT_EQ(read_mesh(write("a.ply", ended + body)).mesh.polygons.size(), 1U) << end.size();
  }
}

TEST_F(PlyFile, ColumnsThatNoPropertyNamesNeverShiftTheNextLine) {
  expect_tetrahedron(read(kVertexElement + kFaceElement,
                          "0 0 0 255\n1 0 0 255\n0 1 0\n0 0 1 255 9\n" + kFaces),
                     {"left out 4 numbers behind the properties of their lines' elements, the "
                      "first at line 10"});
  EXPECT_EQ(fault(kVertexElement + kFaceElement, "0 0 0\n1 0\n0 1 0\n0 0 1\n" + kFaces),
            "a.ply:11: the line ends where z of vertex v1 should follow");
  EXPECT_EQ(fault(kVertexElement + "property uchar red\n" + kFaceElement, kVertices + kFaces),
            "a.ply:11: the line ends where a number of type uchar should follow; in a PLY text "
            "each element is one line");
  EXPECT_EQ(
      fault(kVertexElement + kFaceElement, kVertices + "3 0 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"),
      "a.ply:14: the line ends where vertex_indices of face f0 should follow");
}

TEST_F(PlyFile, StripsBecomeTriangles) {
  const PolygonMesh mesh =
      read(kVertexElement + "element tristrips 1\nproperty list int int vertex_indices\n",
           "0 0 0\n1 0 0\n0 1 0\n1 1 0\n9 0 1 2 3 -1 0 2 1 -1\n")
          .mesh;
  EXPECT_THAT(mesh.polygons,
              ElementsAre(ElementsAre(0, 1, 2), ElementsAre(2, 1, 3), ElementsAre(0, 2, 1)));
  EXPECT_EQ(box_of(mesh), (std::array<Point3, 2>{{{0, 0, 0}, {1, 1, 0}}}));
  EXPECT_THAT(fault(kVertexElement + kFaceElement, kVertices + "3 0 -1 1\n"),
              HasSubstr("a.ply:14: face f0 asks for vertex -1"));
}

TEST_F(PlyFile, FacesAndStripsOfOneFileAreBothRead) {
  const LoadedMesh loaded =
      read(kVertexElement + "element face 2\nproperty list uchar int vertex_index\n" +
               "element tristrips 1\nproperty list int int vertex_indices\n",
           kVertices + "3 0 2 1\n3 0 1 3\n8 1 2 3 -1 2 0 3 -1\n");
  expect_tetrahedron(loaded);
}

TEST_F(PlyFile, WhatIsNoCoordinateMayBeAnything) {
  expect_tetrahedron(
      read(kVertexElement + "property float nx\nproperty float quality\n" + kFaceElement,
           "0 0 0 0 nan\n1 0 0 1.#QNAN 1\n0 1 0 0 -1.#IND\n0 0 1 0 inf\n" + kFaces));
  EXPECT_THAT(fault(kVertexElement + kFaceElement, "0 0 0\n1 nan 0\n0 1 0\n0 0 1\n" + kFaces),
              HasSubstr("a.ply:11: 'nan' where y of vertex v1 should be"));
  const std::string head = "ply\nformat binary_little_endian 1.0\n";
  const std::string nan = Bytes().put<float>({std::numeric_limits<double>::quiet_NaN()}).get();
  std::string vertices;
  for (std::size_t v = 0; v < 4; ++v)
    vertices += nan + binary_vertices().substr(12 * v, 12);
  const std::string element =
      "element vertex 4\nproperty float nx\nproperty float x\nproperty float y\n"
      "property float z\n";
  expect_tetrahedron(read_mesh(write(
      "a.ply", head + element + kFaceElement + "end_header\n" + vertices + binary_faces())));
}

TEST_F(PlyFile, ListsMayStandAnywhere) {
  expect_tetrahedron(
      read(kVertexElement + "property list uchar float tags\n" +
               "element face 4\nproperty list uchar float texcoord\n" +
               "property list uchar int vertex_indices\nproperty int id\n",
           "0 0 0 0\n1 0 0 2 .5 nan\n0 1 0 1 7\n0 0 1 0\n"
           "6 0 0 0 0 0 0 3 0 2 1 5\n0 3 0 1 3 5\n0 3 1 2 3 5\n1 9 3 2 0 3 5\n"));
}

TEST_F(PlyFile, OtherElementsAreCountedWhereverTheyStand) {
  const std::string edges = "element edge 2\nproperty int a\nproperty int b\n";
  const std::string note = "left out 2 elements 'edge'";
  expect_tetrahedron(
      read(edges + kVertexElement + kFaceElement, "0 1\n1 2\n" + kVertices + kFaces), {note});
  expect_tetrahedron(
      read(kVertexElement + edges + kFaceElement, kVertices + "0 1\n1 2\n" + kFaces), {note});
  expect_tetrahedron(read(kVertexElement + kFaceElement + edges, kVertices + kFaces), {note});
  expect_tetrahedron(
      read(kVertexElement + kFaceElement + "element camera 1\nproperty float view_px\n",
           kVertices + kFaces + "0\n"));
  EXPECT_THAT(fault(kVertexElement, kVertices), HasSubstr("no element face or tristrips"));
}

TEST_F(PlyFile, WhatStandsBehindTheLastElementIsCounted) {
  expect_tetrahedron(read(kVertexElement + kFaceElement, kVertices + kFaces + "3 0 1 2\n"),
                     {"left out 1 line behind the last element, at line 18"});
  const std::string head =
      "ply\nformat binary_little_endian 1.0\n" + kVertexElement + kFaceElement + "end_header\n";
  const std::string whole = head + binary_vertices() + binary_faces();
  expect_tetrahedron(read_mesh(write("a.ply", whole + "\n")));
  expect_tetrahedron(read_mesh(write("a.ply", whole + "xyz")),
                     {"left out 3 bytes behind the last element, the first at byte " +
                      std::to_string(whole.size())});
}

TEST_F(PlyFile, FacesWithoutAreaAreLeftOutWithTheirNumber) {
  expect_tetrahedron(
      read(kVertexElement + "element face 5\nproperty list uchar int vertex_indices\n",
           kVertices + kFaces + "3 1 1 2\n"),
      {"left out 1 face without area (a corner twice), at line 18"});
}

}  // namespace
}  // namespace meshgrade
