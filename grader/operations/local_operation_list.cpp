#include "grader/operations/local_operation_list.h"

#include <map>

namespace meshgrade {

#define MESHGRADE_LOCAL_OPERATION(name) LocalOperation name##_operation();
#include "local_operation_list.inc"
#undef MESHGRADE_LOCAL_OPERATION

const LocalOperation* find_local_operation(const std::string& exercise) {
  static const std::map<std::string, LocalOperation> operations{
#define MESHGRADE_LOCAL_OPERATION(name) {#name, name##_operation()},
#include "local_operation_list.inc"
#undef MESHGRADE_LOCAL_OPERATION
  };
  const auto found = operations.find(exercise);
  return found == operations.end() ? nullptr : &found->second;
}

}  // namespace meshgrade
