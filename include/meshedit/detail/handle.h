#pragma once

// HalfedgeIter, VertexIter, EdgeIter, FaceIter and their const versions are Handles. They are
// used like pointers and like the iterators of std::list, and they notice when they are used
// wrongly: see FaultKind.

#include <cstddef>
#include <iterator>
#include <type_traits>

#include "../fault.h"
#include "pool.h"

namespace meshedit {

template <class T>
class Handle {
 public:
  using iterator_category = std::bidirectional_iterator_tag;
  using value_type = std::remove_const_t<T>;
  using difference_type = std::ptrdiff_t;
  using pointer = T*;
  using reference = T&;

  /// A handle that was never set. Using it is a fault; comparing it is not.
  Handle() = default;

  /// A const handle from one that is not. The way back does not exist.
  template <class U, class = std::enable_if_t<std::is_same<T, const U>::value>>
  Handle(const Handle<U>& other)  // NOLINT(google-explicit-constructor)
      : element_(other.element_) {}

  T& operator*() const {
    check_element();
    return *element_;
  }
  T* operator->() const {
    check_element();
    return element_;
  }

  Handle& operator++() {
    check_element();
    element_ = Pool::next(mutable_element());
    return *this;
  }
  Handle operator++(int) {
    Handle old = *this;
    ++*this;
    return old;
  }
  Handle& operator--() {
    if (is_end()) {
      detail::count_step(T::kHandleName);
    } else {
      check_element();
    }
    value_type* previous = Pool::previous(mutable_element());
    if (previous == nullptr) detail::raise_fault(FaultKind::kPastEndHandle, T::kHandleName);
    element_ = previous;
    return *this;
  }
  Handle operator--(int) {
    Handle old = *this;
    --*this;
    return old;
  }

  template <class A, class B>
  friend bool operator==(const Handle<A>& a, const Handle<B>& b);
  template <class A, class B>
  friend bool operator<(const Handle<A>& a, const Handle<B>& b);

 private:
  using Pool = detail::Pool<std::remove_const_t<T>>;
  template <class U>
  friend class Handle;
  template <class U>
  friend class detail::Pool;
  friend struct detail::Inspector;
  friend class Halfedge;
  friend class HalfedgeMesh;
  friend class detail::MeshBuilder;
  template <class U>
  friend U* elementAddress(const Handle<U>& handle);

  explicit Handle(T* element) : element_(element) {}

  value_type* mutable_element() const { return const_cast<value_type*>(element_); }

  bool is_end() const {
    return element_ != nullptr && element_->tag_.state() == detail::SlotState::kEnd;
  }

  void check_element() const {
#ifndef MESHEDIT_UNCHECKED
    if (element_ == nullptr || element_->tag_.state() != detail::SlotState::kLive) {
      report_misuse();
    }
    detail::count_step(T::kHandleName);
#endif
  }

  [[gnu::noinline, gnu::cold]] void report_misuse() const {
    if (element_ == nullptr) detail::raise_fault(FaultKind::kUnsetHandle, T::kHandleName);
    const bool deleted = element_->tag_.state() == detail::SlotState::kDeleted;
    detail::raise_fault(deleted ? FaultKind::kDeletedHandle : FaultKind::kPastEndHandle,
                        T::kHandleName);
  }

  /// The mesh and the place in it, as one number. Unset handles come first, ends last.
  std::uint64_t rank() const {
    if (element_ == nullptr) return 0;
    const detail::Tag tag = element_->tag_;
    return (std::uint64_t{tag.mesh()} << 32U) + tag.index() + 1;
  }

  T* element_ = nullptr;
};

/// The address of an element, whatever state it is in. For printing; nullptr if never set.
template <class T>
T* elementAddress(const Handle<T>& handle) {
  return handle.element_;
}

/// Handles are equal when they point to the same element, or when both were never set.
template <class A, class B>
bool operator==(const Handle<A>& a, const Handle<B>& b) {
  static_assert(std::is_same<std::remove_const_t<A>, std::remove_const_t<B>>::value,
                "handles to different kinds of elements cannot be compared");
  return a.element_ == b.element_;
}

template <class A, class B>
bool operator!=(const Handle<A>& a, const Handle<B>& b) {
  return !(a == b);
}

/// The order of the elements in their list, so that sets and maps of handles have the same
/// order in every run.
template <class A, class B>
bool operator<(const Handle<A>& a, const Handle<B>& b) {
  return a.rank() < b.rank();
}
template <class A, class B>
bool operator>(const Handle<A>& a, const Handle<B>& b) {
  return b < a;
}
template <class A, class B>
bool operator<=(const Handle<A>& a, const Handle<B>& b) {
  return !(b < a);
}
template <class A, class B>
bool operator>=(const Handle<A>& a, const Handle<B>& b) {
  return !(a < b);
}

}  // namespace meshedit
