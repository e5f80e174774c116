#include "grader/submission/course_files.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "grader/base/pattern.h"
#include "grader/base/text.h"
#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

/// The files of src/ by their names without ending; from `bez` on those of single years and of
/// the projects that share its code.
const std::set<std::string>& course_names() {
  static const std::set<std::string> names{
      "bezierCurve", "bezierPatch", "camera",   "collada", "halfEdgeMesh",
      "light",       "main",        "material", "mesh",    "mergeVertices",
      "meshEdit",    "png",         "scene",    "texture", "mutablePriorityQueue",
      "shaderUtils", "bez",         "bbox",     "dirent",  "collada_info",
      "draw_style",  "image",       "sampler",  "viewer",  "collada_viewer",
      "draw_styles"};
  return names;
}

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// Where the parenthesis that opens at `open` closes; npos if it does not.
std::size_t closing(const std::string& code, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < code.size(); ++i) {
    if (code[i] == '(') ++depth;
    if (code[i] == ')' && --depth == 0) return i;
  }
  return std::string::npos;
}

/// Whether squeezed code holds the body of this function, and not just a call of it.
bool defines(const std::string& code, const std::string& function) {
  const std::string head = function + "(";
  for (std::size_t at = code.find(head); at != std::string::npos;
       at = code.find(head, at + 1)) {
    if (at > 0 && is_word_character(code[at - 1])) continue;
    const std::size_t end = closing(code, at + function.size());
    if (end == std::string::npos) continue;
    const std::string rest = code.substr(end + 1, 7);
    if (rest.rfind('{', 0) == 0 || rest.rfind("const{", 0) == 0) return true;
  }
  return false;
}

bool defines_graded_function(const std::string& text) {
  const std::string code = squeeze(code_only(text));
  return std::any_of(graded_functions().begin(), graded_functions().end(),
                     [&](const std::string& name) { return defines(code, name); });
}

}  // namespace

const std::set<std::string>& graded_functions() {
  static const std::set<std::string> names{"BezierCurve::evaluateStep",
                                           "BezierPatch::evaluateStep",
                                           "BezierPatch::evaluate1D",
                                           "BezierPatch::evaluate",
                                           "Vertex::normal",
                                           "HalfedgeMesh::flipEdge",
                                           "HalfedgeMesh::splitEdge",
                                           "MeshResampler::upsample"};
  return names;
}

std::string squeeze(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_space(text[i])) continue;
    const bool after_space = i > 0 && is_space(text[i - 1]);
    if (after_space && !result.empty() && is_word_character(result.back()) &&
        is_word_character(text[i])) {
      result += ' ';
    }
    result += text[i];
  }
  return result;
}

bool includes(const std::string& text, const std::string& header) {
  const std::vector<std::string> lines = split_lines(text);
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    const std::string words = squeeze(line);
    if (words.rfind("#include\"", 0) != 0 && words.rfind("#include<", 0) != 0) return false;
    const std::size_t begin = std::string("#include\"").size();
    const std::string name = words.substr(begin, words.find_first_of("\">", begin) - begin);
    return name.substr(name.rfind('/') + 1) == header;  // npos + 1 is 0
  });
}

bool is_course_file(const SourceFile& file) {
  const std::string stem = file.name.substr(0, file.name.rfind('.'));
  if (course_names().count(stem) == 0) return false;
  if (is_source_name(file.name) && defines_graded_function(file.text)) return false;
  const bool is_program = stem == "main" || stem == "meshEdit";  // these two include it as well
  return is_program || !includes(file.text, "student_code.h");
}

bool is_as_handed_out(const SourceFile& file) {
  if (file.name != "student_code.h") return false;
  static const Pattern form(
      "(using namespace std;)?namespace CGL\\{(using namespace std;)?"
      "class MeshResampler\\{public:MeshResampler\\((void)?\\)(\\{\\};?|;)"
      "~MeshResampler\\((void)?\\)(\\{\\};?|;)void upsample\\(HalfedgeMesh&( ?mesh)?\\);\\};\\}"
      ";?");
  constexpr std::size_t kMost = 1000;  // std::regex goes as deep as a text is long
  const std::string code = squeeze(code_only(file.text));
  return code.size() < kMost && form.matches(code);
}

}  // namespace meshgrade
