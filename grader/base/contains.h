#pragma once

#include <algorithm>
#include <vector>

namespace meshgrade {

template <class Value>
bool contains(const std::vector<Value>& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace meshgrade
