// STL text is words in any case on any line; binary is told by its counts.

#include <gmock/gmock.h>

#include <cstring>

#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kWelded = "welded 12 corners into 4 vertices";
using Facet = std::array<std::array<float, 3>, 3>;

const std::vector<Facet> kFacets = {{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
                                    {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}},
                                    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                    {{{0, 1, 0}, {0, 0, 0}, {0, 0, 1}}}};
const Facet kNoArea = {{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}};

/// A facet with its words parted by `blank`.
std::string text_facet(const Facet& facet, const std::string& blank = "\n") {
  std::ostringstream text;
  text << "facet normal 0 0 nan" << blank << "outer loop" << blank;
  for (const auto& corner : facet) {
    text << "vertex";
    for (const float x : corner)
      text << ' ' << x;
    text << blank;
  }
  text << "endloop" << blank << "endfacet" << blank;
  return text.str();
}

std::string text_facets(const std::string& blank = "\n") {
  std::string text;
  for (const Facet& facet : kFacets)
    text += text_facet(facet, blank);
  return text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string binary(const std::string& header, const std::vector<Facet>& facets,
                   std::uint32_t promised) {
  std::string bytes = header;
  bytes.resize(80, '\0');
  bytes.append(reinterpret_cast<const char*>(&promised), sizeof(promised));
  for (const Facet& facet : facets) {
    bytes.append(12, '\0');  // the normal
    bytes.append(reinterpret_cast<const char*>(&facet), sizeof(facet));
    bytes.append(2, '\0');
  }
  return bytes;
}

class StlFile : public FilesTest {
 protected:
  LoadedMesh read(const std::string& bytes) const { return read_mesh(write("a.stl", bytes)); }
  std::string fault(const std::string& bytes) const { return fault_of(write("a.stl", bytes)); }
};

TEST_F(StlFile, TextIsWordsInAnyCaseOnAnyLine) {
  const std::string text = "solid t\n" + text_facets() + "endsolid t\n";
  std::string upper = text;
  std::transform(upper.begin(), upper.end(), upper.begin(), ::toupper);
  for (const std::string& variant :
       {text, upper, "  \n " + text, "\xEF\xBB\xBF" + text, replaced(text, "\n", "\r\n"),
        replaced(text, "\n", "\r"), "solid t\n" + text_facets(" ") + " endsolid",
        "solid\n" + text_facets("\n\n") + "endsolid\n",
        replaced(replaced(text, "endloop", "end loop"), "endfacet", "end facet"),
        "solid t\n" + text_facets() + "end solid t\n",
        "solid a\n" + text_facet(kFacets[0]) + text_facet(kFacets[1]) +
            "endsolid a\nsolid b\n" + text_facet(kFacets[2]) + text_facet(kFacets[3]) +
            "endsolid b\n",
        "solid t\ncolor 0.7 0.7 0.7\n" + text_facets() + "endsolid t\n"}) {
    SCOPED_TRACE(variant.substr(0, 60));
    expect_tetrahedron(read(variant), {kWelded});
  }
}

TEST_F(StlFile, AMissingEndIsReadAndSaid) {
  expect_tetrahedron(read("solid t\n" + text_facets()),
                     {"the file ends without 'endsolid'; it may be cut off", kWelded});
  EXPECT_THAT(fault("solid t\n" + text_facets() + "facet normal 0 0 0\nouter loop\nvertex 0 0"),
              HasSubstr("the file ends where a coordinate should follow; it may be cut off"));
}

TEST_F(StlFile, LinesThatAreNotOfTheFormatAreCounted) {
  expect_tetrahedron(read("solid t\nmade by hand\n" + text_facets() + "units mm\nendsolid\n"),
                     {"left out 2 lines that are not of STL, the first at line 2", kWelded});
  EXPECT_THAT(fault("solid t\n" + replaced(text_facets(), "facet normal", "facte normal")),
              HasSubstr("'outer' where 'facet' or 'endsolid' should be"));
}

TEST_F(StlFile, BinaryIsToldByItsCounts) {
  for (const std::string header : {"", "solid but binary", "\xEF\xBB\xBF"}) {
    expect_tetrahedron(read(binary(header, kFacets, 4)), {kWelded});
    expect_tetrahedron(read(binary(header, kFacets, 4) + "abcd"),
                       {"left out 4 bytes behind the 4 faces that byte 80 promises, the first "
                        "at byte 284",
                        kWelded});
    EXPECT_THAT(fault(binary(header, kFacets, 5)),
                AllOf(StartsWith("a.stl:byte 80: "), HasSubstr("promises 5 faces"),
                      HasSubstr("284 bytes hold 4")));
  }
  EXPECT_THAT(
      fault(binary("", kFacets, 0)),
      AllOf(HasSubstr("holds no faces"), HasSubstr("left out 200 bytes behind the 0 faces")));
  EXPECT_THAT(fault("nothing"), HasSubstr("neither text"));
}

TEST_F(StlFile, FacesWithoutAreaAreLeftOutWithTheirNumber) {
  std::vector<Facet> facets = kFacets;
  facets.push_back(kNoArea);
  const std::string what = "left out 1 face without area (two corners at one point), at ";
  expect_tetrahedron(read(binary("", facets, 5)), {what + "byte 284", kWelded});
  expect_tetrahedron(read("solid\n" + text_facet(kNoArea) + text_facets() + "endsolid\n"),
                     {what + "line 3", kWelded});
}

}  // namespace
}  // namespace meshgrade
