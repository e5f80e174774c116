#pragma once

#include <set>

#include "course.h"

/// A queue whose items can be taken out again, as edge collapsing needs it. The smallest item
/// is on top. Items are compared by `<` only; equal ones count once.
template <class T>
class MutablePriorityQueue {
 public:
  void insert(const T& item) { items_.insert(item); }
  void remove(const T& item) { items_.erase(item); }
  const T& top() const { return *items_.begin(); }
  void pop() { items_.erase(items_.begin()); }
  bool empty() const { return items_.empty(); }
  Size size() const { return items_.size(); }

 private:
  std::set<T> items_;
};
