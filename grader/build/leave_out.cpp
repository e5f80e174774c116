#include "grader/build/leave_out.h"

#include <algorithm>
#include <cstdlib>

#include "grader/base/pattern.h"
#include "grader/base/text.h"
#include "grader/submission/code_only.h"
#include "grader/submission/course_files.h"
#include "grader/submission/function_extents.h"

namespace meshgrade {
namespace {

struct Complaint {
  int line = 0;
  std::string message;
};

/// Where the place in this file begins that a message names, behind the file's name.
std::size_t place_in(const std::string& file, const std::string& line) {
  const std::string name = file + ":";
  const std::size_t at = line.find(name);
  const bool whole_name =
      at == 0 || (at != std::string::npos && (line[at - 1] == '/' || line[at - 1] == ' '));
  return whole_name ? at + name.size() : std::string::npos;
}

/// "a.cpp:12:5: error: expected ';'" gives 12 and "expected ';'". The linker's
/// "./a.cpp:12: undefined reference to `f'" is understood as well.
std::vector<Complaint> complaints_about(const std::string& file, const std::string& messages) {
  std::vector<Complaint> complaints;
  for (const std::string& line : split_lines(messages)) {
    const std::size_t place = place_in(file, line);
    if (place == std::string::npos) continue;
    for (const std::string mark : {": error: ", ": undefined reference to "}) {
      const std::size_t found = line.find(mark, place);
      if (found == std::string::npos) continue;
      const std::size_t text = mark == ": error: " ? found + mark.size() : found + 2;
      complaints.push_back({std::atoi(line.c_str() + place), line.substr(text)});
      break;
    }
  }
  return complaints;
}

/// A file in which more functions than this are to blame is broken as a whole.
constexpr std::size_t kMostBlamed = 100;

/// Tells on which line a character stands.
class LineNumbers {
 public:
  explicit LineNumbers(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') ends_.push_back(i);
    }
  }

  int line_of(std::size_t offset) const {
    return 1 + static_cast<int>(std::lower_bound(ends_.begin(), ends_.end(), offset) -
                                ends_.begin());
  }

 private:
  std::vector<std::size_t> ends_;
};

/// Replaces a part of the text by `code`, with the line ends that were there.
void replace_part(std::string& text, std::size_t begin, std::size_t end,
                  const std::string& code) {
  std::string lines;
  for (std::size_t i = begin; i < end; ++i) {
    if (text[i] == '\n') lines += '\n';
  }
  text.replace(begin, end - begin, code + lines);
}

/// A body that answers so.
std::string not_implemented(const std::string& function) {
  return "{ ::meshedit::notImplemented(\"" + function + "\"); }";
}

/// "CGL::Vertex::normal" is Vertex::normal.
std::string without_course_namespace(const std::string& name) {
  for (const std::string space : {"CGL::", "::CGL::"}) {
    if (name.rfind(space, 0) == 0) return name.substr(space.size());
  }
  return name;
}

const LeftOut* find(const std::vector<LeftOut>& list, const std::string& function) {
  const auto found = std::find_if(
      list.begin(), list.end(), [&](const LeftOut& item) { return item.function == function; });
  return found == list.end() ? nullptr : &*found;
}

/// The functions to blame, each with its first complaint.
std::vector<std::pair<FunctionExtent, Complaint>> to_blame(
    const std::string& text, const std::vector<Complaint>& complaints) {
  const LineNumbers lines(text);
  const std::vector<FunctionExtent> functions = find_functions(text);
  const bool any_unbalanced = std::any_of(functions.begin(), functions.end(),
                                          [](const auto& f) { return !f.balanced; });
  std::vector<std::pair<FunctionExtent, Complaint>> blamed;
  for (const FunctionExtent& function : functions) {
    if (any_unbalanced) {
      if (!function.balanced) {
        blamed.push_back(
            {function, {lines.line_of(function.body), "its braces { } do not match"}});
      }
      continue;
    }
    const int begin = lines.line_of(function.begin);
    const int end = lines.line_of(function.end);
    const auto first =
        std::find_if(complaints.begin(), complaints.end(),
                     [&](const Complaint& c) { return begin <= c.line && c.line <= end; });
    if (first != complaints.end()) blamed.push_back({function, *first});
  }
  return blamed;
}

/// Whether a body, from brace to brace, says nothing. `head` is what stands in front of it.
bool does_nothing(const std::string& head, const std::string& body) {
  static const Pattern form(
      "\\{"
      "(?:showError\\(\\);|(?:std::)?(?:cout|cerr)<<[^;]*;)*"  // a message
      "(?:(?!return|throw|delete)(?:std::)?(?:vector<)?\\w+(?:>| "
      ")(\\w+)(?:\\([0-9.,]*\\))?;)?"  // a variable
      "(?:return(?:;| (\\w+);|"        // by its name
      "\\{\\};|"
      " (?:std::)?(?:vector<)?(?:CGL::)?(?:Vector[23]D|EdgeIter|VertexIter)>?"  // a new one
      "[\\(\\{][0-9.,]*[\\)\\}];))?"
      "\\}");
  constexpr std::size_t kMost = 400;  // std::regex goes as deep as a text is long
  const std::string code = squeeze(code_only(body));
  Pattern::Groups found;
  if (code.size() > kMost || !form.matches(code, found)) return false;
  const std::string returned = found[2];
  if (returned.empty() || returned == found[1]) return true;
  return Pattern("\\b" + returned + "\\s{0,20}\\)").is_in(head);
}

/// Whether a body, from brace to brace, only refuses.
bool only_refuses(const std::string& body) {
  static const Pattern form(
      "\\{(?:\\(void\\)\\w+;){0,8}(?:return;|return(?: std::| )nullopt;|return\\{\\};|"
      "return false;)?\\}");
  constexpr std::size_t kMost = 400;  // std::regex goes as deep as a text is long
  const std::string code = squeeze(code_only(body));
  return code.size() <= kMost && form.matches(code);
}

}  // namespace

void LeavingOut::mark_unwritten(const std::set<std::string>& functions) {
  mark(functions, does_nothing);
}

void LeavingOut::mark_refusing(const std::set<std::string>& functions) {
  mark(functions,
       [](const std::string& /*head*/, const std::string& body) { return only_refuses(body); });
}

template <class DoesNothing>
void LeavingOut::mark(const std::set<std::string>& functions, DoesNothing does_nothing) {
  std::vector<FunctionExtent> found = find_functions(text_);
  std::reverse(found.begin(), found.end());  // so that offsets before stay right
  for (const FunctionExtent& function : found) {
    const std::string name = without_course_namespace(function.name);
    const std::string head = text_.substr(function.begin, function.body - function.begin);
    const std::string body = text_.substr(function.body, function.end - function.body);
    if (!function.balanced || functions.count(name) == 0 || !does_nothing(head, body)) continue;
    replace_part(text_, function.body, function.end, not_implemented(name));
  }
}

bool LeavingOut::learn_from(const std::string& messages) {
  auto blamed = to_blame(text_, complaints_about(file_, messages));
  if (blamed.size() > kMostBlamed) return false;
  std::reverse(blamed.begin(), blamed.end());  // so that offsets before stay right
  for (const auto& [function, complaint] : blamed) {
    if (find(left_out_, function.name) != nullptr) {
      replace_part(text_, function.begin, function.end, "");
      continue;
    }
    replace_part(text_, function.body, function.end, not_implemented(function.name));
    left_out_.push_back({function.name, complaint.line, complaint.message, false});
  }
  std::sort(left_out_.begin(), left_out_.end(),
            [](const LeftOut& a, const LeftOut& b) { return a.line < b.line; });
  return !blamed.empty();
}

template <class Chosen>
void LeavingOut::remove(Chosen chosen) {
  std::vector<FunctionExtent> functions = find_functions(text_);
  std::reverse(functions.begin(), functions.end());  // so that offsets before stay right
  for (const FunctionExtent& function : functions) {
    if (chosen(function.name)) replace_part(text_, function.begin, function.end, "");
  }
}

void LeavingOut::remove_members(const std::string& class_name) {
  remove([&](const std::string& name) { return name.rfind(class_name + "::", 0) == 0; });
}

void LeavingOut::remove_function(const std::string& name) {
  const std::string qualified = "::" + name;  // behind a namespace
  remove([&](const std::string& written) {
    return written == name || (written.size() > qualified.size() &&
                               written.compare(written.size() - qualified.size(),
                                               std::string::npos, qualified) == 0);
  });
}

}  // namespace meshgrade
