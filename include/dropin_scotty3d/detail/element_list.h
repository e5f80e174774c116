#pragma once

// The lists of a Halfedge_Mesh and the references to their elements. In the course they are
// std::list and its iterators; these behave the same and notice when they lead to no element.
//
// What is erased goes to a list of free elements at once and stays readable and writable. A new
// element takes the place of the one that was freed first, if there is any. So a reference that
// was kept may lead to another element later, and `++` on one to an erased element goes on
// among the free ones. Homework relies on all of this. Not so in Fall 2020 to Spring 2022,
// where the elements of a list are freed as those of any: using one is a fault then
// (kStaysWhenErased of the element), and no place is taken again, so that it is noticed.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>

#include "meshedit/fault.h"

namespace meshedit {
namespace detail {
namespace scotty3d {

enum class LinkState : std::uint32_t {
  kLive,    ///< an element of the list
  kErased,  ///< one that was erased
  kEnd,     ///< no element: where a list ends
};

/// What stands in front of every element: its neighbours in the list, and who it is.
struct Link {
  Link* previous = this;
  Link* next = this;
  LinkState state = LinkState::kEnd;
  std::uint32_t order = UINT32_MAX;  ///< that of the places in memory; ends come last
  std::uint64_t birth = 0;           ///< tells an element from others that had the same place

  void leave_list() {
    previous->next = next;
    next->previous = previous;
  }
  /// As the last one before `end`.
  void join_list(Link& end) {
    previous = end.previous;
    next = &end;
    previous->next = this;
    end.previous = this;
  }
};

template <class T>
struct Node : Link {
  T element;
};

template <class T>
class ElementList;

/// A reference to an element: a list iterator that is checked at every use.
template <class T>
class Reference {
  using Plain = std::remove_const_t<T>;

 public:
  using iterator_category = std::bidirectional_iterator_tag;
  using value_type = Plain;
  using difference_type = std::ptrdiff_t;
  using pointer = T*;
  using reference = T&;

  /// Leads to nothing. Using it is a fault; comparing it is not.
  Reference() = default;

  /// A const reference from one that is not. The way back does not exist.
  template <class U, class = std::enable_if_t<std::is_same<T, const U>::value>>
  Reference(const Reference<U>& other)  // NOLINT(google-explicit-constructor)
      : link_(other.link_) {}

  T& operator*() const { return element(); }
  T* operator->() const { return &element(); }

  Reference& operator++() {
    check();
    link_ = link_->next;
    return *this;
  }
  Reference operator++(int) {
    Reference old = *this;
    ++*this;
    return old;
  }
  Reference& operator--() {
    count_step(Plain::kReferenceName);
    if (link_ == nullptr) raise_fault(FaultKind::kUnsetHandle, Plain::kReferenceName);
    if (link_->previous->state == LinkState::kEnd) refuse_end();
    link_ = link_->previous;
    return *this;
  }
  Reference operator--(int) {
    Reference old = *this;
    --*this;
    return old;
  }

  /// Where it leads, without a check; nullptr if nowhere.
  Link* link() const { return link_; }

 private:
  template <class U>
  friend class Reference;
  friend class ElementList<Plain>;

  explicit Reference(Link* link) : link_(link) {}

  T& element() const {
    check();
    return static_cast<Node<Plain>*>(link_)->element;
  }

  void check() const {
    if (link_ == nullptr) raise_fault(FaultKind::kUnsetHandle, Plain::kReferenceName);
    if (link_->state == LinkState::kEnd) refuse_end();
    if (!Plain::kStaysWhenErased && link_->state == LinkState::kErased)
      raise_fault(FaultKind::kDeletedHandle, Plain::kReferenceName);
    count_step(Plain::kReferenceName);
  }

  [[noreturn]] static void refuse_end() {
    raise_fault(FaultKind::kEndReference, Plain::kReferenceName);
  }

  Link* link_ = nullptr;
};

template <class A, class B>
constexpr bool kSameElements =
    std::is_same<std::remove_const_t<A>, std::remove_const_t<B>>::value;

template <class A, class B, class = std::enable_if_t<kSameElements<A, B>>>
bool operator==(const Reference<A>& a, const Reference<B>& b) {
  return a.link() == b.link();
}
template <class A, class B, class = std::enable_if_t<kSameElements<A, B>>>
bool operator!=(const Reference<A>& a, const Reference<B>& b) {
  return a.link() != b.link();
}

/// In place of the addresses that the course compares: the same order in every run. Unset
/// references come first, ends last.
template <class T>
std::uint64_t rank_of(const Reference<T>& reference) {
  return reference.link() == nullptr ? 0 : std::uint64_t{1} + reference.link()->order;
}

template <class A, class B, class = std::enable_if_t<kSameElements<A, B>>>
bool operator<(const Reference<A>& a, const Reference<B>& b) {
  return rank_of(a) < rank_of(b);
}
template <class A, class B, class = std::enable_if_t<kSameElements<A, B>>>
bool operator>(const Reference<A>& a, const Reference<B>& b) {
  return b < a;
}
template <class A, class B, class = std::enable_if_t<kSameElements<A, B>>>
bool operator<=(const Reference<A>& a, const Reference<B>& b) {
  return !(b < a);
}
template <class A, class B, class = std::enable_if_t<kSameElements<A, B>>>
bool operator>=(const Reference<A>& a, const Reference<B>& b) {
  return !(a < b);
}

/// A list of elements, used like a std::list that can be read. Only a mesh adds to it and
/// erases from it.
template <class T>
class ElementList {
 public:
  using value_type = T;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using reference = T&;
  using const_reference = const T&;
  using iterator = Reference<T>;
  using const_iterator = Reference<const T>;
  using reverse_iterator = std::reverse_iterator<iterator>;
  using const_reverse_iterator = std::reverse_iterator<const_iterator>;

  ElementList() = default;
  ElementList(const ElementList&) = delete;
  ElementList& operator=(const ElementList&) = delete;
  ~ElementList() = default;

  iterator begin() { return iterator(memory_->live.next); }
  iterator end() { return iterator(&memory_->live); }
  const_iterator begin() const { return cbegin(); }
  const_iterator end() const { return cend(); }
  const_iterator cbegin() const { return const_iterator(memory_->live.next); }
  const_iterator cend() const { return const_iterator(&memory_->live); }
  reverse_iterator rbegin() { return reverse_iterator(end()); }
  reverse_iterator rend() { return reverse_iterator(begin()); }
  const_reverse_iterator rbegin() const { return const_reverse_iterator(end()); }
  const_reverse_iterator rend() const { return const_reverse_iterator(begin()); }

  std::size_t size() const { return memory_->size; }
  bool empty() const { return size() == 0; }
  T& front() { return *begin(); }
  T& back() { return *--end(); }
  const T& front() const { return *begin(); }
  const T& back() const { return *--end(); }

  /// A new last element, all of it as it begins.
  iterator emplace() {
    Node<T>* node = take_node();
    node->element = T();
    node->state = LinkState::kLive;
    node->birth = ++memory_->births;
    node->join_list(memory_->live);
    ++memory_->size;
    return iterator(node);
  }

  /// Moves an element to the free ones. The caller says what it holds from now on.
  /// @return false if it is there already
  bool release(const iterator& erased) {
    erased.check();
    if (erased.link_->state == LinkState::kErased) return false;
    erased.link_->leave_list();
    erased.link_->state = LinkState::kErased;
    erased.link_->join_list(memory_->free);
    --memory_->size;
    return true;
  }

  /// All places in memory, live or erased, in the order in which they were made.
  std::deque<Node<T>>& nodes() { return memory_->nodes; }
  const std::deque<Node<T>>& nodes() const { return memory_->nodes; }

  iterator reference_to(Link* link) { return iterator(link); }

  /// Whether this is where the list, or that of the free elements, ends.
  bool is_end(const Link* link) const {
    return link == &memory_->live || link == &memory_->free;
  }

  void swap(ElementList& other) { memory_.swap(other.memory_); }

 private:
  /// Apart from the list, so that a mesh can be moved and its ends stay where they are.
  struct Memory {
    Link live;  ///< the end of the list
    Link free;
    std::deque<Node<T>> nodes;
    std::size_t size = 0;
    std::uint64_t births = 0;
  };

  Node<T>* take_node() {
    Link* first = memory_->free.next;
    if (T::kStaysWhenErased && first != &memory_->free) {
      first->leave_list();
      return static_cast<Node<T>*>(first);
    }
    Node<T>& node = memory_->nodes.emplace_back();
    node.order = static_cast<std::uint32_t>(memory_->nodes.size() - 1);
    return &node;
  }

  std::unique_ptr<Memory> memory_ = std::make_unique<Memory>();
};

}  // namespace scotty3d
}  // namespace detail
}  // namespace meshedit

namespace std {  // NOLINT(cert-dcl58-cpp): for types of our own
template <class T>
struct hash<meshedit::detail::scotty3d::Reference<T>> {
  size_t operator()(const meshedit::detail::scotty3d::Reference<T>& reference) const {
    return hash<uint64_t>()(meshedit::detail::scotty3d::rank_of(reference));
  }
};
}  // namespace std
