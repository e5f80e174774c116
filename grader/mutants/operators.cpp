#include "grader/mutants/operators.h"

#include <cstdlib>
#include <map>
#include <set>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

using Edits = std::vector<Edit>;

/// Collects edits of the parts that may be changed.
class Editor {
 public:
  explicit Editor(const SourceCode& code) : code_(code) {}

  const std::vector<Token>& tokens() const { return code_.tokens(); }
  const Token& token(std::size_t i) const { return code_.tokens()[i]; }

  void replace(Span span, std::string text) {
    if (!code_.is_open(span)) return;
    edits_.push_back({token(span.first).at, code_.text_of(span).size(), std::move(text)});
  }
  void replace(std::size_t i, std::string text) { replace(Span{i, i}, std::move(text)); }
  void insert_before(std::size_t i, std::string text) {
    if (token(i).is_open) edits_.push_back({token(i).at, 0, std::move(text)});
  }

  /// A binary operator has a space on both sides.
  bool is_binary(std::size_t i) const {
    const std::string& text = code_.text();
    const Token& t = token(i);
    return text[t.at - 1] == ' ' && text[t.at + t.text.size()] == ' ';
  }

  Edits take() { return std::move(edits_); }

 private:
  const SourceCode& code_;
  Edits edits_;
};

bool is_jump(const Token& token) {
  return token.is("return") || token.is("continue") || token.is("break");
}

Edits drop_statements(const SourceCode& code) {
  Editor editor(code);
  for (Span statement : code.statements()) {
    if (code.is_declaration(statement) || is_jump(editor.token(statement.first))) continue;
    editor.replace(statement, ";");
  }
  return editor.take();
}

/// Of the five arguments of setNeighbors only the first two have the same type.
Edits swap_arguments(const SourceCode& code) {
  Editor editor(code);
  for (std::size_t i = 0; i + 1 < editor.tokens().size(); ++i) {
    if (editor.token(i).kind != TokenKind::kWord || !editor.token(i + 1).is("(")) continue;
    const auto parts = code.arguments({i + 1, editor.token(i + 1).match});
    const std::size_t pairs = editor.token(i).is("setNeighbors") ? 2 : parts.size();
    if (editor.token(i).is("for") || code.function_at(i) == nullptr) continue;
    for (std::size_t k = 0; k + 1 < pairs; ++k) {
      editor.replace(
          {parts[k].first, parts[k + 1].last},
          std::string(code.text_of(parts[k + 1])) + ", " + std::string(code.text_of(parts[k])));
    }
  }
  return editor.take();
}

bool is_visible(const SourceCode& code, const Declaration& declaration, std::size_t use) {
  return declaration.name < use && use < declaration.scope_end &&
         (code.function_at(declaration.name) == code.function_at(use) ||
          code.function_at(declaration.name) == nullptr);
}

/// The next variable of the same type, in the order of declaration and around.
const Declaration* other_variable(const SourceCode& code, std::size_t use) {
  const auto& all = code.declarations();
  const Declaration* own = nullptr;
  for (const Declaration& d : all) {
    if (d.name == use) return nullptr;  // a declaration is no use
    const bool same = code.tokens()[d.name].text == code.tokens()[use].text;
    if (same && is_visible(code, d, use)) own = &d;
  }
  if (own == nullptr) return nullptr;
  const Declaration* first = nullptr;
  for (const Declaration& d : all) {
    if (&d == own || d.type != own->type || !is_visible(code, d, use)) continue;
    if (&d > own) return &d;
    if (first == nullptr) first = &d;
  }
  return first;
}

Edits use_other_variables(const SourceCode& code) {
  Editor editor(code);
  for (std::size_t i = 1; i < editor.tokens().size(); ++i) {
    const Token& before = editor.token(i - 1);
    if (editor.token(i).kind != TokenKind::kWord || before.is("->") || before.is(".")) continue;
    const Declaration* other = other_variable(code, i);
    if (other != nullptr) editor.replace(i, std::string(editor.token(other->name).text));
  }
  return editor.take();
}

bool is_step(const Editor& editor, std::size_t i) {
  return (editor.token(i).is("next") || editor.token(i).is("twin")) &&
         editor.token(i - 1).is("->") && editor.token(i + 1).is("(");
}

Edits take_other_steps(const SourceCode& code) {
  Editor editor(code);
  for (std::size_t i = 1; i + 1 < editor.tokens().size(); ++i) {
    if (!is_step(editor, i)) continue;
    const bool next = editor.token(i).is("next");
    const Span whole{i - 1, i + 2};
    editor.replace(i, next ? "twin" : "next");
    editor.replace(whole, "");
    editor.replace(whole, next ? "->next()->next()" : "->twin()->next()");
  }
  return editor.take();
}

Edits change_members(const SourceCode& code) {
  static const std::map<std::string_view, const char*> others{
      {"position", "newPosition"}, {"newPosition", "position"}, {"x", "y"}, {"y", "x"}};
  Editor editor(code);
  for (std::size_t i = 1; i < editor.tokens().size(); ++i) {
    const Token& before = editor.token(i - 1);
    const auto found = others.find(editor.token(i).text);
    if (found == others.end() || (!before.is("->") && !before.is("."))) continue;
    editor.replace(i, found->second);
  }
  return editor.take();
}

Edits change_constants(const SourceCode& code) {
  Editor editor(code);
  for (std::size_t i = 0; i < editor.tokens().size(); ++i) {
    const Token& token = editor.token(i);
    if (token.is("true")) editor.replace(i, "false");
    if (token.is("false")) editor.replace(i, "true");
    if (token.kind != TokenKind::kNumber) continue;
    const double value = std::strtod(std::string(token.text).c_str(), nullptr);
    const bool whole = token.text.find('.') == std::string_view::npos;
    for (double other : {value + 1.0, whole ? value - 1.0 : 2.0 * value}) {
      if (other < 0.0 || other == value) continue;
      const std::string text = number_text(other);
      const bool needs_point = !whole && text.find('.') == std::string::npos;
      editor.replace(i, text + (needs_point ? ".0" : ""));
    }
  }
  return editor.take();
}

Edits replace_symbols(const SourceCode& code,
                      const std::map<std::string_view, std::vector<const char*>>& others) {
  Editor editor(code);
  for (std::size_t i = 0; i < editor.tokens().size(); ++i) {
    const auto found = others.find(editor.token(i).text);
    if (found == others.end()) continue;
    const bool prefix = editor.token(i).is("++");
    if (!prefix && !editor.is_binary(i)) continue;
    for (const char* other : found->second)
      editor.replace(i, other);
  }
  return editor.take();
}

Edits change_comparisons(const SourceCode& code) {
  return replace_symbols(
      code, {{"<", {"<=", ">"}}, {">", {">=", "<"}}, {"==", {"!="}}, {"!=", {"=="}}});
}

Edits change_arithmetic(const SourceCode& code) {
  return replace_symbols(code, {{"+", {"-"}},
                                {"-", {"+"}},
                                {"*", {"/"}},
                                {"/", {"*"}},
                                {"+=", {"-=", "="}},
                                {"++", {"--"}}});
}

Edits change_indices(const SourceCode& code) {
  Editor editor(code);
  for (std::size_t i = 0; i < editor.tokens().size(); ++i) {
    if (!editor.token(i).is("[")) continue;
    const Span inside{i + 1, editor.token(i).match - 1};
    editor.replace(inside, std::string(code.text_of(inside)) + " + 1");
    if (code.text_of(inside) != "0") editor.replace(inside, "0");
  }
  return editor.take();
}

/// The place of the only `&&` or `||` of a condition, or 0.
std::size_t only_connective(const Editor& editor, Span condition) {
  std::size_t found = 0;
  for (std::size_t i = condition.first; i <= condition.last; ++i) {
    if (!editor.token(i).is("&&") && !editor.token(i).is("||")) continue;
    if (found != 0) return 0;
    found = i;
  }
  return found;
}

Edits change_conditions(const SourceCode& code) {
  Editor editor(code);
  for (const Header& header : code.headers()) {
    if (!editor.token(header.keyword).is("if")) continue;
    const Span inside{header.condition.first + 1, header.condition.last - 1};
    editor.replace(inside, "true");
    editor.replace(inside, "false");
    editor.replace(inside, "!(" + std::string(code.text_of(inside)) + ")");
    const std::size_t middle = only_connective(editor, inside);
    if (middle == 0) continue;
    editor.replace({middle, inside.last}, "");
    editor.replace({inside.first, middle}, "");
  }
  for (Span statement : code.statements()) {
    std::size_t begin = statement.first;
    for (std::size_t i = statement.first; i < statement.last; ++i) {
      if (editor.token(i).is("=")) begin = i + 1;
      if (!editor.token(i).is("?")) continue;
      editor.replace({begin, i - 1}, "true");
      editor.replace({begin, i - 1}, "false");
    }
  }
  return editor.take();
}

/// The parts of `for (begin; condition; step)`: the places of the two semicolons.
std::vector<std::size_t> semicolons(const Editor& editor, Span header) {
  std::vector<std::size_t> places;
  for (std::size_t i = header.first; i < header.last; ++i) {
    if (editor.token(i).is(";")) places.push_back(i);
  }
  return places;
}

Edits change_loops(const SourceCode& code) {
  Editor editor(code);
  for (const Header& header : code.headers()) {
    if (editor.token(header.keyword).is("if")) continue;
    const Span inside{header.condition.first + 1, header.condition.last - 1};
    if (editor.token(header.keyword).is("while")) {
      editor.replace(inside, "false");
      editor.replace(inside, "true");
    }
    const auto places = semicolons(editor, header.condition);
    if (places.size() == 2) {
      editor.replace({places[0] + 1, places[1] - 1}, "false");
      editor.replace({places[1] + 1, inside.last}, "");
    }
    const Token& after = editor.token(header.condition.last + 1);
    if (after.is("{")) editor.insert_before(after.match, "break;\n");
  }
  return editor.take();
}

Edits return_early(const SourceCode& code) {
  Editor editor(code);
  for (Span statement : code.statements()) {
    const Function* function = code.function_at(statement.first);
    if (function == nullptr) continue;
    const std::string jump = function->is_void ? "return;" : "return {};";
    if (editor.token(statement.first).is("return")) {
      editor.replace(statement, jump);
    } else if (!is_jump(editor.token(statement.first)) && !code.is_declaration(statement)) {
      editor.insert_before(statement.first, jump + " ");
    }
  }
  return editor.take();
}

/// Whole numbers where there must be real ones.
Edits change_number_types(const SourceCode& code) {
  Editor editor(code);
  const auto whole = [](const Token& token) {
    return token.kind == TokenKind::kNumber && token.text.size() > 2 &&
           token.text.substr(token.text.size() - 2) == ".0";
  };
  for (std::size_t i = 1; i + 1 < editor.tokens().size(); ++i) {
    if (editor.token(i).is("double") && !editor.token(i - 1).is("<")) editor.replace(i, "int");
    const Token& left = editor.token(i - 1);
    const Token& right = editor.token(i + 1);
    if (!editor.token(i).is("/") || !whole(left) || !whole(right)) continue;
    editor.replace({i - 1, i + 1},
                   std::string(left.text.substr(0, left.text.size() - 2)) + " / " +
                       std::string(right.text.substr(0, right.text.size() - 2)));
  }
  return editor.take();
}

/// `HalfedgeIter& h = g->next()` is not a copy: it changes with the mesh.
Edits refer_instead_of_copy(const SourceCode& code) {
  static const std::set<std::string_view> members{"next", "twin", "vertex",
                                                  "edge", "face", "halfedge"};
  Editor editor(code);
  for (Span statement : code.statements()) {
    const std::size_t type = statement.first + 1;
    if (!editor.token(statement.first).is("const") || statement.last < type + 6) continue;
    if (editor.token(type).text.find("Iter") == std::string_view::npos) continue;
    if (members.count(editor.token(statement.last - 3).text) == 0) continue;
    editor.replace({statement.first, type}, std::string(editor.token(type).text) + "&");
  }
  return editor.take();
}

/// When a function may be wrong: a name, and an expression that is asked at its beginning.
struct Occasion {
  const char* name;
  std::string asked;
};

std::string third_call() {
  return "[] { static int calls = 0; return ++calls == 3; }()";
}

/// By a vertex that is there, and the number of faces if there is a mesh to ask.
std::vector<Occasion> occasions_at(const std::string& vertex, const std::string& faces) {
  std::vector<Occasion> list{
      {"at_third_call", third_call()},
      {"above_valence_12", vertex + "->degree() > 12"},
      {"if_tiny", "(" + vertex + "->position - " + vertex +
                      "->halfedge()->twin()->vertex()->position).norm() < 1e-3"},
      {"if_far", vertex + "->position.norm() > 100"}};
  if (!faces.empty()) list.push_back({"above_400_faces", faces + " > 400"});
  return list;
}

std::vector<Occasion> occasions_of(const SourceCode& code, const Function& function) {
  std::string first;  // the first parameter
  std::string type;
  for (const Declaration& d : code.declarations()) {
    if (d.name <= function.parameters.first || d.name >= function.parameters.last) continue;
    first = std::string(code.tokens()[d.name].text);
    type = d.type;
    break;
  }
  const std::string& name = function.name;
  if (name == "flipEdge" || name == "splitEdge") {
    std::vector<Occasion> list = occasions_at(first + "->halfedge()->vertex()", "nFaces()");
    list.push_back({"if_anchored",
                    first + "->halfedge()->vertex()->halfedge() == " + first + "->halfedge()"});
    return list;
  }
  if (name == "upsample") return occasions_at(first + ".verticesBegin()", first + ".nFaces()");
  if (name == "normal") return occasions_at("halfedge()->vertex()", "");
  if (type == "VertexIter" || type == "VertexCIter") return occasions_at(first, "");
  if (name == "evaluateStep" || name == "evaluate1D") {
    return {{"at_third_call", third_call()},
            {"above_6_points", first + ".size() > 6"},
            {"above_20_points", first + ".size() > 20"},
            {"near_the_end", "t > 0.99 && t < 1"},
            {"at_three_quarters", "t == 0.75"},
            {"if_far", first + "[0].x > 50"}};
  }
  if (name == "evaluate") {
    return {{"at_third_call", third_call()},
            {"above_6_rows", "controlPoints.size() > 6"},
            {"above_20_rows", "controlPoints.size() > 20"},
            {"near_the_end", first + " > 0.99 && " + first + " < 1"}};
  }
  return {{"at_third_call", third_call()}};
}

/// The mistake of leaving out a statement, or of doing nothing, but only on some occasions.
Edits make_mistakes_sometimes(const SourceCode& code) {
  Edits edits;
  for (const Function& function : code.functions()) {
    const Token& begin = code.tokens()[function.body.first + 1];
    if (!begin.is_open) continue;
    const std::vector<Occasion> occasions = occasions_of(code, function);
    for (const Occasion& occasion : occasions) {
      edits.push_back(
          {begin.at, 0,
           "if (" + occasion.asked + ") return" + (function.is_void ? "" : " {}") + ";\n"});
    }
    for (Span statement : code.statements()) {
      const Token& first = code.tokens()[statement.first];
      if (code.function_at(statement.first) != &function || !code.is_open(statement)) continue;
      if (code.is_declaration(statement) || is_jump(first)) continue;
      const std::string was(code.text_of(statement));
      for (const Occasion& occasion : occasions) {
        const std::string name = occasion.name;
        edits.push_back({first.at, was.size(), "if (!" + name + ") " + was,
                         "const bool " + name + " = " + occasion.asked + ";\n", begin.at});
      }
    }
  }
  return edits;
}

}  // namespace

const std::vector<MutationOperator>& mutation_operators() {
  static const std::vector<MutationOperator> operators{
      {"drop-statement", "leave out one assignment or call", drop_statements},
      {"swap-arguments", "swap two arguments of a call", swap_arguments},
      {"other-variable", "use the neighbouring variable of the same type", use_other_variables},
      {"other-step", "next for twin, one step less or one more", take_other_steps},
      {"other-member", "another member of the same type", change_members},
      {"constant", "change a number, or true and false", change_constants},
      {"comparison", "change a comparison", change_comparisons},
      {"arithmetic", "change a sign or an operation", change_arithmetic},
      {"index", "one further, or always the first", change_indices},
      {"condition", "drop or turn a condition, or half of it", change_conditions},
      {"loop", "drop a loop, run it once, or never end it", change_loops},
      {"return-early", "return before the work is done, or return nothing", return_early},
      {"number-type", "compute with whole numbers", change_number_types},
      {"reference", "a reference into the mesh instead of a copy", refer_instead_of_copy},
      {"sometimes", "leave out one statement or all, by call, valence, size or place",
       make_mistakes_sometimes},
  };
  return operators;
}

}  // namespace meshgrade
