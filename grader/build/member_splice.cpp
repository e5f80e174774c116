#include "grader/build/member_splice.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "grader/base/pattern.h"
#include "grader/base/text.h"
#include "grader/build/scotty3d_classes.h"
#include "grader/submission/code_only.h"
#include "grader/submission/course_files.h"
#include "grader/submission/function_extents.h"

namespace meshgrade {
namespace {

using Words = std::set<std::string>;

/// The classes that can be added to, and the file of each that the shared headers include. The
/// grader has two curves and two patches, of which a homework sees one.
const std::map<std::string, std::string>& open_classes() {
  static const std::map<std::string, std::string> files{
      {"Halfedge", "meshedit_added_halfedge.h"}, {"Vertex", "meshedit_added_vertex.h"},
      {"Edge", "meshedit_added_edge.h"},         {"EdgeRecord", "meshedit_added_edge_record.h"},
      {"Face", "meshedit_added_face.h"},         {"HalfedgeMesh", "meshedit_added_mesh.h"},
      {"BezierCurve", "meshedit_added_curve.h"}, {"BezierPatch", "meshedit_added_patch.h"}};
  return files;
}

/// The files of the two classes that are others in 2017 to 2019.
const std::map<std::string, std::string>& open_classes_of_2017() {
  static const std::map<std::string, std::string> files{
      {"BezierCurve", "meshedit_added_curve_2017.h"},
      {"BezierPatch", "meshedit_added_patch_2017.h"}};
  return files;
}

/// The classes of the skeleton, and the files of what is added to them.
const std::map<std::string, std::string>& open_classes_of(Dialect dialect) {
  return is_scotty3d(dialect) ? scotty3d_open_classes() : open_classes();
}

/// In 2016 the Bezier part is another one, and left out.
bool is_open(const std::string& class_name, Dialect dialect) {
  return open_classes_of(dialect).count(class_name) != 0 &&
         (dialect != Dialect::kCourse2016 || class_name.rfind("Bezier", 0) != 0);
}

/// What the course's classes hold that the grader's have as well: data by name, functions by
/// name and number of parameters.
const std::map<std::string, Words>& course_members() {
  static const std::map<std::string, Words> members{
      {"Halfedge",
       {"twin/0", "next/0", "vertex/0", "edge/0", "face/0", "isBoundary/0", "setNeighbors/5",
        "_twin", "_next", "_vertex", "_edge", "_face"}},
      {"Vertex",
       {"halfedge/0", "isBoundary/0", "degree/0", "normal/0", "computeCentroid/0", "position",
        "newPosition", "centroid", "isNew", "_halfedge"}},
      {"Edge",
       {"halfedge/0", "isBoundary/0", "length/0", "newPosition", "isNew", "record",
        "_halfedge"}},
      {"EdgeRecord", {"edge", "optimalPoint", "score"}},
      {"Face",
       {"halfedge/0", "degree/0", "isBoundary/0", "normal/0", "_halfedge", "_isBoundary"}},
      {"BezierCurve", {"evaluateStep/1", "controlPoints", "t", "numControlPoints"}},
      {"BezierPatch", {"evaluateStep/2", "evaluate1D/2", "evaluate/2", "controlPoints"}},
      {"HalfedgeMesh",
       {"build/2",         "nHalfedges/0",     "nVertices/0",       "nEdges/0",
        "nFaces/0",        "nBoundaries/0",    "halfedgesBegin/0",  "halfedgesEnd/0",
        "verticesBegin/0", "verticesEnd/0",    "edgesBegin/0",      "edgesEnd/0",
        "facesBegin/0",    "facesEnd/0",       "boundariesBegin/0", "boundariesEnd/0",
        "newHalfedge/0",   "newVertex/0",      "newEdge/0",         "newFace/0",
        "newBoundary/0",   "deleteHalfedge/1", "deleteVertex/1",    "deleteEdge/1",
        "deleteFace/1",    "deleteBoundary/1", "flipEdge/1",        "splitEdge/1",
        "check_for/1",     "halfedges",        "vertices",          "edges",
        "faces",           "boundaries"}}};
  return members;
}

const std::map<std::string, Words>& course_members_of_2017() {
  static const std::map<std::string, Words> members = [] {
    std::map<std::string, Words> changed = course_members();
    changed["BezierCurve"] = {"evaluateStep/0", "controlPoints", "evaluatedLevels", "t",
                              "numControlPoints"};
    changed["BezierPatch"] = {"evaluate1D/2", "evaluate/2", "controlPoints"};
    return changed;
  }();
  return members;
}

/// The course has these, and the grader only where they are used: they are large.
bool is_rare_member_of_course(const ClassMember& member) {
  return member.names[0] == "quadric" && member.text.find("Matrix4x4") != std::string::npos;
}

bool is_of_course(const ClassMember& member, Dialect dialect) {
  if (is_scotty3d(dialect)) return is_in_our_scotty3d_class(member, dialect);
  const bool old = dialect == Dialect::kCourse2017;
  const Words& known =
      (old ? course_members_of_2017() : course_members()).at(member.class_name);
  return std::all_of(member.names.begin(), member.names.end(), [&](const std::string& name) {
    const bool is_call = member.kind == MemberKind::kFunction;
    return known.count(is_call ? name + "/" + std::to_string(member.parameters) : name) != 0;
  });
}

Words words_of(const std::string& text) {
  Words words;
  std::string word;
  for (char c : code_only(text) + " ") {
    if (is_word_character(c)) {
      word += c;
    } else {
      if (!word.empty()) words.insert(word);
      word.clear();
    }
  }
  return words;
}

std::string own_text(const Submission& submission) {
  std::string text;
  for (const SourceFile* file : own_files(submission))
    text += file->text + "\n";
  return text;
}

/// How many letters have to be changed, added or taken out, upper and lower case being equal.
std::size_t letters_apart(const std::string& a, const std::string& b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::string without_namespace(const std::string& name) {
  return name.rfind("CGL::", 0) == 0 ? name.substr(5) : name;
}

/// The member of the course that a name is nearly the same as; empty if it is like none.
std::string meant_by(const MemberUse& use) {
  const auto members = course_members().find(use.class_name);
  if (members == course_members().end()) return {};
  const std::size_t most = use.name.size() < 3 ? 0 : use.name.size() < 8 ? 1 : 2;
  std::string nearest;
  std::size_t least = most + 1;
  for (const std::string& known : members->second) {
    const std::string name = known.substr(0, known.find('/'));
    const std::size_t apart = letters_apart(use.name, name);
    if (apart >= least) continue;
    nearest = name;
    least = apart;
  }
  return nearest;
}

/// Whether a file defines both this function and the one of the course that it might be taken
/// for: `evaluate2D` beside `evaluate1D` is no slip of the pen.
bool is_beside_the_meant_one(const MemberUse& use, const Submission& submission) {
  Words defined;
  for (const SourceFile& source : submission.sources) {
    for (const FunctionExtent& function : find_functions(source.text))
      defined.insert(without_namespace(function.name));
  }
  return defined.count(use.class_name + "::" + use.name) != 0 &&
         defined.count(use.class_name + "::" + meant_by(use)) != 0;
}

/// The type of a member by how it is used in this code; empty if that does not tell.
std::string type_from_use(const std::string& code, const std::string& name) {
  // A pattern goes one call deeper with each repetition: none may repeat as often as a
  // student's file has characters.
  const std::string plain = squeeze(code);
  const std::string member = "(?:->|\\.)" + name + "\\b";
  const auto used = [&](const std::string& before, const std::string& behind) {
    return Pattern(before + member + behind).is_in(plain);
  };
  if (used("", "\\s?\\(")) return {};
  if (used("", "\\s?=\\s?(?:true|false)\\b") || used("!\\s?\\w{1,80}", "") ||
      used("", "\\s?[!=]=\\s?(?:true|false)\\b")) {
    return "bool";
  }
  if (used("", "\\s?=\\s?Vector3D\\b") || used("", "\\.(?:x|y|z|norm|unit|normalize)\\b")) {
    return "Vector3D";
  }
  if (used("", "\\s?[-+*/]?=\\s?[-0-9]{0,20}\\.[0-9]")) return "double";
  if (used("", "(?:\\+\\+|--)") || used("(?:\\+\\+|--)\\w{1,80}", "") ||
      used("", "\\s?[-+]?=\\s?-?[0-9]{1,20}\\s?;") || used("", "\\s?%") ||
      used("", "\\s?[-+]\\s?[0-9]{1,20}\\b(?!\\.)")) {
    return "int";
  }
  if (name.rfind("is", 0) == 0 || name.rfind("has", 0) == 0 || name.rfind("was", 0) == 0) {
    return "bool";
  }
  return {};
}

int line_of(const std::string& text, std::size_t offset) {
  return 1 + static_cast<int>(std::count(
                 text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

std::string line_mark(const AddedPiece& piece) {
  const std::string file = piece.file.empty() ? "told_from_use" : piece.file;
  return "#line " + std::to_string(piece.member.line) + " \"" + file + "\"\n";
}

/// The declaration of a function that is defined here.
std::string head_of(const AddedPiece& piece) {
  const std::string code = code_only(piece.member.text);
  return code.substr(0, code.find('{')) + ";\n";
}

std::string joined_name(const ClassMember& member) {
  return (member.class_name.empty() ? "" : member.class_name + "::") + join(member.names, ", ");
}

/// How the file of the data begins: with what the course's headers let students use.
constexpr const char* kDataHead =
    "#pragma once\n#include <algorithm>\n#include <array>\n#include <cmath>\n"
    "#include <deque>\n#include <functional>\n#include <list>\n#include <map>\n"
    "#include <queue>\n#include <set>\n#include <string>\n#include <unordered_map>\n"
    "#include <unordered_set>\n#include <utility>\n#include <vector>\n"
    "#include \"dropin/CGL/color.h\"\n#include \"dropin/CGL/matrix3x3.h\"\n"
    "#include \"dropin/CGL/matrix4x4.h\"\n"
    "namespace CGL = meshedit;\n"
    "#ifdef MESHEDIT_ADDED_FUNCTIONS\nusing namespace std;\n#endif\n"
    "namespace meshedit {\nnamespace added {\nusing namespace std;\n";

/// The pieces as code, by where they belong.
struct Texts {
  std::map<std::string, std::string> data;       ///< by class
  std::map<std::string, std::string> functions;  ///< by class
  std::string later;
  std::string free_functions;  ///< their declarations
};

Texts texts_of(const std::vector<AddedPiece>& pieces) {
  Texts texts;
  for (const AddedPiece& piece : pieces) {
    const std::string text = line_mark(piece) + piece.member.text + "\n";
    const std::string& class_name = piece.member.class_name;
    if (piece.later) {
      texts.later += text;
      if (class_name.empty()) texts.free_functions += line_mark(piece) + head_of(piece);
    } else {
      const bool is_function = piece.member.kind == MemberKind::kFunction;
      (is_function ? texts.functions : texts.data)[class_name] += text;
    }
  }
  return texts;
}

}  // namespace

MemberSplice::MemberSplice(const Submission& submission) : dialect_(submission.dialect) {
  if (is_scotty3d(dialect_)) add_scotty3d(submission);
  if (!is_berkeleys(submission.dialect)) return;
  for (const SourceFile& header : submission.course_headers)
    add_header(header);
  for (const SourceFile& header : submission.course_headers)
    add_definitions(header);
  for (const SourceFile& source : submission.course_sources)
    add_definitions(source);
  keep_used(submission);
}

void MemberSplice::add_scotty3d(const Submission& submission) {
  for (const SourceFile& header : submission.course_headers) {
    if (header.name != "halfedge.h") continue;
    add_header(header);
    add_definitions(header);
  }
  for (const SourceFile& source : submission.course_sources)
    add_definitions(source);
  keep_used(submission);
  for (AddedPiece& piece : scotty3d_members_defined(submission.sources, dialect_,
                                                    {declared_.begin(), declared_.end()})) {
    declared_.emplace_back(piece.member.class_name, piece.member.names[0]);
    pieces_.push_back(std::move(piece));
  }
}

void MemberSplice::add_header(const SourceFile& header) {
  for (const auto& [class_name, file] : open_classes_of(dialect_)) {
    if (!is_open(class_name, dialect_)) continue;
    for (const ClassMember& member : find_members(header.text, class_name)) {
      if (is_of_course(member, dialect_)) continue;
      for (const std::string& name : member.names)
        declared_.emplace_back(class_name, name);
      pieces_.push_back({header.name, member, false});
    }
  }
}

/// Functions behind the classes: of members that were added, and in a header free ones.
void MemberSplice::add_definitions(const SourceFile& file) {
  if (declared_.empty() && !is_header_name(file.name)) return;
  for (const FunctionExtent& function : find_functions(file.text)) {
    const std::string name = is_scotty3d(dialect_) ? without_scotty3d_mesh(function.name)
                                                   : without_namespace(function.name);
    const std::size_t colons = name.find("::");
    const std::string class_name = colons == std::string::npos ? "" : name.substr(0, colons);
    const MemberUse member{class_name, class_name.empty() ? name : name.substr(colons + 2), ""};
    const bool is_free = class_name.empty() && is_header_name(file.name) &&
                         name != "elementAddress" && name.rfind("operator", 0) != 0;
    const bool is_own = is_free || is_declared(member) || name == "Vertex::computeCentroid";
    if (!is_own || !function.balanced) continue;
    ClassMember definition;
    definition.class_name = class_name;
    definition.kind = MemberKind::kFunction;
    definition.names = {member.name};
    definition.text = file.text.substr(function.begin, function.end - function.begin);
    definition.line = line_of(file.text, function.begin);
    definition.last_line = line_of(file.text, function.end);
    const std::string first = definition.text.substr(0, definition.text.find_first_of(" \t\n"));
    if (first != "inline" && first != "static" && first != "template") {
      definition.text = "inline " + definition.text;
    }
    pieces_.push_back({file.name, definition, true});
  }
}

void MemberSplice::keep_used(const Submission& submission) {
  Words used = words_of(own_text(submission));
  const auto is_used = [&](const AddedPiece& piece) {
    const auto& names = piece.member.names;
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return used.count(name) != 0; });
  };
  for (std::size_t before = 0; before != used.size();) {
    before = used.size();
    for (const AddedPiece& piece : pieces_) {
      if (is_used(piece)) used.merge(words_of(piece.member.text));
    }
  }
  pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(),
                               [&](const AddedPiece& piece) { return !is_used(piece); }),
                pieces_.end());
}

bool MemberSplice::add_from_use(const std::vector<MemberUse>& uses,
                                const Submission& submission) {
  const std::string code = code_only(own_text(submission));
  bool added = false;
  for (const MemberUse& use : uses) {
    if (!is_open(use.class_name, dialect_) || is_declared(use)) continue;
    const bool is_quadric =
        use.name == "quadric" && (use.class_name == "Vertex" || use.class_name == "Face");
    if (!is_quadric && is_slip(use) && !is_beside_the_meant_one(use, submission)) continue;
    const std::string type = is_quadric ? "Matrix4x4" : type_from_use(code, use.name);
    if (type.empty()) {
      added = add_defined(use, submission) || added;
      continue;
    }
    declared_.emplace_back(use.class_name, use.name);
    ClassMember member{
        use.class_name, MemberKind::kData, {use.name}, 0, type + " " + use.name + "{};", 1, 1};
    pieces_.push_back({"", member, false});
    added = true;
    if (is_quadric) continue;
    from_use_.push_back(use.place + " uses " + use.class_name + "::" + use.name +
                        ", which no header that was handed in declares: graded as if it were " +
                        "a member `" + type + " " + use.name + "`, " +
                        (type == "bool" ? "false" : "zero") + " at first");
  }
  return added;
}

/// The head of the definition, without the class, is the declaration.
bool MemberSplice::add_defined(const MemberUse& use, const Submission& submission) {
  const std::string name = use.class_name + "::" + use.name;
  bool added = false;
  for (const SourceFile& source : submission.sources) {
    for (const FunctionExtent& function : find_functions(source.text)) {
      if (without_namespace(function.name) != name) continue;
      std::string head =
          code_only(source.text.substr(function.begin, function.body - function.begin));
      const std::size_t at = head.find(function.name);
      if (at == std::string::npos) continue;
      head.replace(at, function.name.size(), use.name);
      const ClassMember member{
          use.class_name, MemberKind::kFunction, {use.name}, 0, head + ";", 1, 1};
      pieces_.push_back({"", member, false});
      added = true;
    }
  }
  if (!added) return false;
  declared_.emplace_back(use.class_name, use.name);
  from_use_.push_back(use.place + " defines " + name +
                      ", which no header that was handed in declares: graded as if one did");
  return true;
}

void MemberSplice::drop_blamed(const std::string& messages) {
  std::vector<AddedPiece> kept;
  for (const AddedPiece& piece : pieces_) {
    const std::string trouble =
        complaint_about(messages, piece.file, piece.member.line, piece.member.last_line);
    if (trouble.empty()) {
      kept.push_back(piece);
      continue;
    }
    troubles_.push_back(piece.file + ":" + std::to_string(piece.member.line) + ": " +
                        joined_name(piece.member) + " cannot be taken over: " + trouble);
  }
  if (kept.size() == pieces_.size()) return drop_all("they do not compile");
  pieces_ = std::move(kept);
}

void MemberSplice::drop_all(const std::string& reason) {
  if (pieces_.empty()) return;
  pieces_.clear();
  from_use_.clear();
  troubles_.push_back("members that were added to the course's headers cannot be taken over: " +
                      reason);
}

bool MemberSplice::is_declared(const MemberUse& member) const {
  return std::find(declared_.begin(), declared_.end(),
                   std::pair(member.class_name, member.name)) != declared_.end();
}

bool MemberSplice::is_slip(const MemberUse& use) {
  return !meant_by(use).empty();
}

std::vector<SourceFile> MemberSplice::files() const {
  Texts texts = texts_of(pieces_);
  if (is_scotty3d(dialect_)) {
    for (const auto& [class_name, text] : texts.data)
      texts.functions[class_name] = text + texts.functions[class_name];
    return scotty3d_added_files(texts.functions, texts.later);
  }
  std::string data = kDataHead;
  std::string bases;
  std::vector<SourceFile> files;
  for (const auto& [class_name, file] : open_classes()) {
    data += "struct DataOf" + class_name + " {\n" + texts.data[class_name] + "};\n";
    bases +=
        "template <> struct Added<" + class_name + "> : added::DataOf" + class_name + " {};\n";
    const auto old = open_classes_of_2017().find(class_name);
    const bool is_old = dialect_ == Dialect::kCourse2017 && old != open_classes_of_2017().end();
    if (is_old) files.push_back({file, ""});
    files.push_back(
        {is_old ? old->second : file,
         "#ifdef MESHEDIT_ADDED_FUNCTIONS\n" + texts.functions[class_name] + "\n#endif\n"});
  }
  files.push_back({"meshedit_added_data.h", data +
                                                "}  // namespace added\nnamespace detail {\n" +
                                                bases + "}\n#ifdef MESHEDIT_ADDED_FUNCTIONS\n" +
                                                texts.free_functions + "#endif\n}\n"});
  files.push_back({kLater, "#pragma once\nnamespace meshedit {\n" + texts.later + "\n}\n"});
  return files;
}

std::vector<std::string> MemberSplice::notes() const {
  std::vector<std::string> notes = troubles_;
  notes.insert(notes.end(), from_use_.begin(), from_use_.end());
  std::map<std::string, std::vector<std::string>> taken;  // by file
  for (const AddedPiece& piece : pieces_) {
    if (piece.file.empty() || is_rare_member_of_course(piece.member)) continue;
    // What the course itself hands out in the student's files is nobody's addition.
    const bool is_known =
        is_scotty3d(dialect_) &&
        (is_source_name(piece.file) || is_provided_by_scotty3d(piece.member.names[0]));
    if (is_known) continue;
    std::vector<std::string>& names = taken[piece.file];
    const std::string name = joined_name(piece.member);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  for (const auto& [file, names] : taken) {
    notes.push_back(file + " holds members of your own, which are taken over for this: " +
                    join(names, ", "));
  }
  return notes;
}

}  // namespace meshgrade
