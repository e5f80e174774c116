// OFF is words, not lines: but where lines tell one vertex or face each, they count.

#include <gmock/gmock.h>

#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class OffFile : public FilesTest {
 protected:
  LoadedMesh read(const std::string& text) const { return read_mesh(write("a.off", text)); }
  std::string fault(const std::string& text) const { return fault_of(write("a.off", text)); }

  static constexpr const char* kVertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  static constexpr const char* kFaces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const std::string body = std::string(kVertices) + kFaces;
};

TEST_F(OffFile, CountsMayStandBehindTheKeywordOrBeGluedToIt) {
  for (const std::string header :
       {"OFF\n4 4 6\n", "OFF 4 4 6\n", "OFF4 4 6\n", "4 4 6\n", "off\n4 4 6\n",
        "OFF\n4\n4\n6\n", "OFF\n4 4\n", "OFF\n4 4\n6\n",
        "# made\nOFF # here\n\n4 4 0 # and here\n", "\xEF\xBB\xBFOFF\n4 4 6\n",
        "  OFF\r\n4 4 6\r\n", "OFF\r4 4 6\r"}) {
    SCOPED_TRACE(header);
    expect_tetrahedron(read(header + body));
  }
}

TEST_F(OffFile, WordsMayStandOnAnyLine) {
  std::string one_line = "OFF 4 4 6 " + body;
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  std::string one_word_a_line = one_line;
  std::replace(one_word_a_line.begin(), one_word_a_line.end(), ' ', '\n');
  const std::string vertices_on_a_line = "0 0 0 1 0 0 0 1 0 0 0 1\n";
  for (const std::string& text :
       {one_line, one_word_a_line, "OFF\n4 4 6\n" + vertices_on_a_line + kFaces,
        "OFF\n4 4 6\n" + vertices_on_a_line + "3 0 2 1 3 0 1 3 3 1 2 3 3 2 0 3\n",
        "OFF\n4 4 6\n" + std::string(kVertices) + "3 0 2 1 3 0 1 3\n3 1 2 3 3 2 0 3\n",
        "OFF\n4 4 6\n" + std::string(kVertices) + "3\n0 2 1\n3 0\n1 3\n3 1 2\n3\n3 2 0 3\n",
        std::string("OFF\n4 4 6\n0 0 0 1 0 0\n0 1 0 0 0 1\n") + kFaces}) {
    SCOPED_TRACE(text);
    expect_tetrahedron(read(text));
  }
}

TEST_F(OffFile, TwoVerticesOnALineAreTwo) {
  const PolygonMesh mesh = read("OFF\n3 1 3\n0 0 0 1 0 0\n0 1 0\n3 0 1\n2\n").mesh;
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.polygons, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}}));
}

/// The tetrahedron with `columns` behind each position.
std::string with_columns(const std::string& header, const std::string& columns,
                         const std::string& faces) {
  std::string text = header + "\n4 4 6\n";
  for (const char* position : {"0 0 0", "1 0 0", "0 1 0", "0 0 1"})
    text += std::string(position) + columns + "\n";
  return text + faces;
}

TEST_F(OffFile, PrefixesTellTheColumnsEvenWithoutLines) {
  for (const auto& [keyword, columns] :
       std::vector<std::pair<std::string, std::string>>{{"STOFF", " .5 .5"},
                                                        {"NOFF", " 0 0 1"},
                                                        {"COFF", " 255 0 0 255"},
                                                        {"COFF", " 1 0 0"},
                                                        {"CNOFF", " 0 0 1 .1 .2 .3 1"},
                                                        {"NCOFF", " 0 0 1 9 9 9 9"},
                                                        {"STNOFF", " 0 0 1 0 0"},
                                                        {"STCNOFF", " 0 0 1 .1 .2 .3 1 0 0"},
                                                        {"OFF", " 7 7 7"}}) {
    SCOPED_TRACE(keyword + columns);
    std::string text = with_columns(keyword, columns, kFaces);
    expect_tetrahedron(read(text));
    if (keyword == "OFF") continue;  // nothing but the line tells that there are columns
    std::replace(text.begin(), text.end(), '\n', ' ');
    expect_tetrahedron(read(text));
  }
}

TEST_F(OffFile, ColoursBehindFacesEndWithTheirLine) {
  for (const std::string colour : {"", " 2", " 1 0 0", " 255 0 0 255", " .1 .2 .3 .4"}) {
    SCOPED_TRACE(colour);
    expect_tetrahedron(read("OFF\n4 4 6\n" + std::string(kVertices) + "3 0 2 1" + colour +
                            "\n3 0 1 3" + colour + "\n3 1 2 3\n3 2 0 3" + colour + "\n"));
  }
}

TEST_F(OffFile, DimensionsAreFilledUpAndDivided) {
  const std::string faces = kFaces;
  expect_tetrahedron(read("4OFF\n4 4 6\n0 0 0 1\n2 0 0 2\n0 -1 0 -1\n0 0 .5 .5\n" + faces));
  expect_tetrahedron(read("nOFF\n3\n4 4 6\n" + std::string(kVertices) + faces));
  expect_tetrahedron(read("nOFF 3 4 4 6\n" + std::string(kVertices) + faces));
  expect_tetrahedron(read("4nOFF\n3\n4 4 6\n0 0 0 1\n2 0 0 2\n0 1 0 1\n0 0 1 1\n" + faces));
  const PolygonMesh flat = read("nOFF\n2\n3 1 3\n0 0\n1 0\n0 1\n3 0 1 2\n").mesh;
  EXPECT_EQ(flat.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_THAT(fault("nOFF\n5\n3 1 3\n"), StartsWith("a.off:2: vertices of 5 dimensions"));
  EXPECT_THAT(fault("4OFF\n3 1 3\n0 0 0 1\n1 0 0 0\n0 1 0 1\n3 0 1 2\n"),
              StartsWith("a.off:4: vertex v1 lies at infinity"));
}

TEST_F(OffFile, UTF16IsRead) {
  std::string wide = "\xFF\xFE";
  for (const char c : "OFF\n4 4 6\n" + body)
    wide += {c, '\0'};
  expect_tetrahedron(read(wide));
}

TEST_F(OffFile, LinesAndPointsAmongTheFacesAreCounted) {
  expect_tetrahedron(read("OFF\n4 6 6\n" + std::string(kVertices) + "2 0 1\n1 3\n" + kFaces),
                     {"left out 2 faces with fewer than 3 corners, the first at line 7"});
}

TEST_F(OffFile, LinesBehindTheLastFaceAreCounted) {
  expect_tetrahedron(read("OFF\n4 4 6\n" + body + "3 0 1 2\n# end\n3 0 2 1\n"),
                     {"left out 2 lines more than the counts at the top promise, the first at "
                      "line 11"});
}

TEST_F(OffFile, FaultsAreToldByTheLineAndNeverShifted) {
  // One number is missing, and one word of the next line would fit in its place.
  EXPECT_EQ(fault("OFF\n4 4 6\n0 0 0\n1 0\n0 1 0\n0 0 1\n" + std::string(kFaces)),
            "a.off:4: the line ends where a coordinate should follow");
  EXPECT_EQ(
      fault("OFF\n4 4 6\n" + std::string(kVertices) + "3 0 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"),
      "a.off:7: the line ends where a vertex number should follow");
  EXPECT_EQ(
      fault("OFF\n4 4 6\n" + std::string(kVertices) + "3 0 2 1\n3 0 1 4\n3 1 2 3\n3 2 0 3\n"),
      "a.off:8: face f1 asks for vertex 4, but the 4 vertices are numbered from 0");
  EXPECT_THAT(fault("OFF\n5 4 6\n" + body), StartsWith("a.off:"))
      << "a face taken for a vertex";
  EXPECT_THAT(fault("OFF\n3 4 6\n" + body), StartsWith("a.off:6: face f0 has 0 corners"));
  EXPECT_THAT(fault("OFF\n4 4 6\n" + body.substr(0, body.size() - 9)),
              HasSubstr("the file ends where face f3 should follow"));
  EXPECT_EQ(fault("OFF BINARY\n\1\2"), "a.off:1: binary OFF is not read; save it as text");
  EXPECT_THAT(fault("solid t\n"), StartsWith("a.off:1: 'solid' where the word OFF should be"));
}

}  // namespace
}  // namespace meshgrade
