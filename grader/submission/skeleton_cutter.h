#pragma once

#include <string>
#include <string_view>

namespace meshgrade {

/// Makes a file of the student skeleton out of the same file of the model solution.
///
/// A solution is marked by two comment lines that stand alone:
///
///     // SOLUTION BEGIN HalfedgeMesh::flipEdge
///     ...
///     // SOLUTION END
///
/// An indented part is (a piece of) the body of the function that BEGIN names. It becomes two
/// lines of the same indentation: a comment that tells the student to begin here, and a call of
/// `notImplemented` with that name. A part that starts at the margin has no name and holds
/// helpers of the solution: it vanishes, with one of the empty lines around it. All other text
/// stays as it is, byte for byte.
///
/// @param source     the text of the model solution
/// @param file_name  how messages call it
/// @return the text of the skeleton
/// @throws GraderError  "<file>:<line>: ..." for a mark that is not of this form, has no
///                      partner, or stands inside another part
std::string cut_solution(std::string_view source, const std::string& file_name);

}  // namespace meshgrade
