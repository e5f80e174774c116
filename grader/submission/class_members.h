#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace meshgrade {

enum class MemberKind {
  kData,
  kFunction,  ///< also static data, which take no place in an object
  kType,      ///< a type that is defined in the class, or another name for one
};

/// A member as a class of a header declares it.
struct ClassMember {
  std::string class_name;
  MemberKind kind = MemberKind::kData;
  std::vector<std::string> names;  ///< several for `bool a, b;`
  int parameters = 0;              ///< of a function
  std::string text;                ///< the declaration, with its body and its semicolon
  int line = 0;                    ///< in the header
  int last_line = 0;
};

/// The members of this class, as a C++ text declares them. Constructors, destructors,
/// operators and friends are passed over. Data without an initial value are given `{}`, or what
/// a constructor of the class gives them, if that is a number, a truth value or a Vector3D.
/// A text that is no C++ gives some members or none.
std::vector<ClassMember> find_members(std::string_view header, const std::string& class_name);

}  // namespace meshgrade
