#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/operations/local_operation.h"

namespace meshgrade {

/// Which vertex of a mesh stands for each label of an answer.
using LabelMap = std::map<Label, Ref>;

/// Compares faces as cyclic lists, winding and multiplicity included. Labels below
/// `Answer::first_free` are vertices of the same number; for the others, any vertices that make
/// all faces agree.
/// @return nothing if there are none
std::optional<LabelMap> match_faces(const Answer& answer, const FaceLists& actual);

/// What differs between the faces of an answer and others, as far as the labels are not free.
struct FaceDifference {
  std::vector<std::string> missing;  ///< "v0-v1-v4", "v1-new-v2": faces of the answer
  std::vector<std::string> surplus;  ///< and of the others
  bool turned = false;               ///< all that is missing is there with the other winding
};
FaceDifference difference(const Answer& answer, const FaceLists& actual);

}  // namespace meshgrade
