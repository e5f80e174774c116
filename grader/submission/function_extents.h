#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meshgrade {

/// Where a function stands in its file, as offsets of characters.
struct FunctionExtent {
  std::string name;       ///< as it is written: "HalfedgeMesh::flipEdge", "lerp"
  std::size_t begin = 0;  ///< of its return type
  std::size_t body = 0;   ///< of the opening brace
  std::size_t end = 0;    ///< behind the closing brace
  bool balanced = true;   ///< its braces are in order, as far as one can tell
};

/// The definitions of functions in a C++ file, at the level of namespaces, in order. Classes
/// and what is in them are passed over.
///
/// Works on files that do not compile. A missing brace makes a body swallow what follows: it is
/// taken to end where the definition of a member function begins (`Type Class::name(...) {`),
/// for no such definition can stand inside another; or, in the last function, before the brace
/// that the namespace needs. A brace too many ends a body early: what follows up to the brace
/// that closes too much is counted to the function.
std::vector<FunctionExtent> find_functions(std::string_view text);

}  // namespace meshgrade
