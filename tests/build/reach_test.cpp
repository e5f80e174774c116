#include "grader/build/reach.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace meshgrade {
namespace {

using Places = std::vector<std::size_t>;

const std::string kFlipText = "EdgeIter HalfedgeMesh::flipEdge(EdgeIter e) { return e; }\n";
const std::string kNormalText = "Vector3D Vertex::normal() const { return {}; }\n";
const std::string kLoop =
    "void MeshResampler::upsample(HalfedgeMesh& m) { m.flipEdge(m.edgesBegin()); }\n";

Places reached(const std::vector<std::string>& texts, const std::string& function) {
  std::vector<SourceFile> sources;
  for (const std::string& text : texts)
    sources.push_back(
        {"file" + std::to_string(sources.size()) + ".cpp",
         "#include \"meshedit/meshedit.h\"\nnamespace meshedit {\n" + text + "}\n"});
  return files_reached(sources, {function});
}

TEST(Reach, IsTheOwnFileAndThoseThatItCalls) {
  const std::vector<std::string> texts{kFlipText, kNormalText, kLoop};
  EXPECT_EQ(reached(texts, "Vertex::normal"), (Places{1}));
  EXPECT_EQ(reached(texts, "MeshResampler::upsample"), (Places{0, 2}));
  // Whoever names the function could be in its way when they are linked.
  EXPECT_EQ(reached(texts, "HalfedgeMesh::flipEdge"), (Places{0, 2}));
}

TEST(Reach, GoesOnThroughHelpersAndTypes) {
  EXPECT_EQ(
      reached({"double half(double x);\n" + kNormalText + "Vector3D f() { return half(1); }\n",
               "int third() { return 3; }\ndouble half(double x) { return third() * x; }\n",
               "int third();\n", kFlipText},
              "Vertex::normal"),
      (Places{0, 1, 2}));
}

TEST(Reach, TwoDefinitionsOfOneNameBelongTogether) {
  EXPECT_EQ(reached({"int helper() { return 1; }\n" + kNormalText,
                     "int helper() { return 2; }\n" + kFlipText},
                    "Vertex::normal"),
            (Places{0, 1}));
}

TEST(Reach, WhatCouldActWithoutBeingCalledIsInEverything) {
  for (const char* text :
       {"int counter = 0;\n", "static Vector3D origin;\n", "Noisy noisy(1);\n",
        "Noisy noisy{1};\n", "struct Noisy { static int count; };\n",
        "struct Noisy { Noisy(); } noisy;\n", "#define normal other\n",
        "void* operator new(std::size_t);\n", "extern int other;\n",
        "void* memcpy(void* to, const void* from, std::size_t n) { return to; }\n",
        "void f() { asm(\"nop\"); }\n", "auto f = [] { return 1; };\n"}) {
    EXPECT_EQ(reached({kNormalText, text}, "Vertex::normal"), (Places{0, 1})) << text;
  }
}

TEST(Reach, OfAFileWithMacrosGoesOnToWhatItCalls) {
  for (const char* directive :
       {"#define ON_RIM(x) (x)->isBoundary()\n", "#pragma GCC optimize(\"O2\")\n",
        "#ifndef PI\n#define PI 3.14\n#endif\n", "#define FLIP flipEdge\n"}) {
    EXPECT_EQ(reached({kFlipText, kNormalText, directive + kLoop}, "MeshResampler::upsample"),
              (Places{0, 2}))
        << directive;
  }
  const std::string by_macro =
      "#define FLIP flipEdge\nvoid MeshResampler::upsample(HalfedgeMesh& m) { m.FLIP({}); }\n";
  EXPECT_EQ(reached({kFlipText, kNormalText, by_macro}, "MeshResampler::upsample"),
            (Places{0, 2}));
}

TEST(Reach, OfWordsThatCannotBeReadIsEverything) {
  for (const char* text : {"#define CALL(what) what##Edge\n", "void f() { asm(\"nop\"); }\n",
                           "#define FLIP fl\\\nipEdge\n",
                           "int gr\xC3\xB6\xC3\x9F"
                           "e() { return 1; }\n"}) {
    EXPECT_EQ(reached({kFlipText, kNormalText, text + kLoop}, "MeshResampler::upsample"),
              (Places{0, 1, 2}))
        << text;
  }
}

TEST(Reach, ConstantsAndTypesDoNotAct) {
  for (const char* text : {"constexpr double kU = 3.0 / 16.0;\n", "struct Corner { int a; };\n",
                           "enum Side { left, right };\n", "using Handle = EdgeIter;\n",
                           "using namespace std;\n", "namespace { int f() { return 1; } }\n"}) {
    EXPECT_EQ(reached({kNormalText, text}, "Vertex::normal"), (Places{0})) << text;
  }
}

TEST(Reach, OfTheReferenceIsNoMoreThanItCalls) {
  std::vector<SourceFile> sources;
  for (const char* name : {"bezier_curve", "bezier_patch", "edge_flip", "edge_split",
                           "loop_subdivision", "vertex_normal"}) {
    std::ifstream file(MESHGRADE_SOURCE_DIR "/reference/" + std::string(name) + ".cpp");
    sources.push_back({name, {std::istreambuf_iterator<char>(file), {}}});
  }
  EXPECT_EQ(files_reached(sources, {"Vertex::normal"}), (Places{5}));
  EXPECT_EQ(files_reached(sources, {"MeshResampler::upsample"}), (Places{2, 3, 4}));
}

}  // namespace
}  // namespace meshgrade
