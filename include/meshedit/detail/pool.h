#pragma once

// Storage of mesh elements with the guarantees of std::list that students rely on: elements
// keep their address while others come and go, new ones are appended at the end, a stored end
// stays valid, and a running loop visits what is appended meanwhile. Elements lie next to each
// other in chunks that double in size, which makes walks several times faster than a list.
//
// A slot is never used twice. So a handle to a deleted element always finds the mark "deleted"
// and never, by accident, somebody else.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>

#include "../fault.h"
#include "added.h"

namespace meshedit {

template <class T>
class Handle;
class Halfedge;
class Vertex;
class Edge;
class Face;
class EdgeRecord;

namespace detail {

enum class SlotState : std::uint32_t {
  kLoose = 0,    ///< a copy of an element, outside any mesh
  kLive = 1,     ///< an element of a mesh
  kDeleted = 2,  ///< an element that was deleted
  kLink = 3,     ///< no element: leads on to the next chunk or to the end
  kEnd = 4,      ///< no element: the end of the list
};

constexpr std::size_t kMaxElements = (std::size_t{1} << 28U) - 1;

/// What the places of a second list of elements of one kind begin with, so that handles to both
/// can be kept in one set or map: those of boundary loops, which are faces, too.
constexpr std::size_t kSecondList = std::size_t{1} << 28U;

enum class ElementKind : std::uint32_t { kNone = 0, kHalfedge, kVertex, kEdge, kFace };

template <class T>
struct KindOf {
  static constexpr ElementKind kValue = ElementKind::kNone;
};
template <>
struct KindOf<Halfedge> {
  static constexpr ElementKind kValue = ElementKind::kHalfedge;
};
template <>
struct KindOf<Vertex> {
  static constexpr ElementKind kValue = ElementKind::kVertex;
};
template <>
struct KindOf<Edge> {
  static constexpr ElementKind kValue = ElementKind::kEdge;
};
template <>
struct KindOf<Face> {
  static constexpr ElementKind kValue = ElementKind::kFace;
};

/// Eight bytes in front of every element: its state, its place in the list, its kind and its
/// mesh.
class Tag {
 public:
  Tag() = default;
  Tag(SlotState state, std::size_t index, std::uint32_t mesh,
      ElementKind kind = ElementKind::kNone)
      : word_(static_cast<std::uint32_t>(index << 3U) | static_cast<std::uint32_t>(state)),
        mesh_(mesh | (static_cast<std::uint32_t>(kind) << kMeshBits)) {}

  SlotState state() const { return static_cast<SlotState>(word_ & 7U); }
  std::uint32_t index() const { return word_ >> 3U; }
  std::uint32_t mesh() const { return mesh_ & ((1U << kMeshBits) - 1); }
  ElementKind kind() const { return static_cast<ElementKind>(mesh_ >> kMeshBits); }

 private:
  static constexpr std::uint32_t kMeshBits = 29;

  std::uint32_t word_ = 0;
  std::uint32_t mesh_ = 0;
};

struct Inspector;
class MeshBuilder;

/// Base of all elements. Copying an element copies its contents, never its place in a mesh.
class Element {
 public:
  Element() = default;
  Element(const Element& /*other*/) : Element() {}
  Element& operator=(const Element& /*other*/) { return *this; }
  ~Element() = default;

  /// The element as what it is, if it is that and belongs to a mesh; otherwise nullptr.
  Halfedge* getHalfedge();
  Vertex* getVertex();
  Edge* getEdge();
  Face* getFace();

 private:
  template <class T>
  friend class Pool;
  template <class T>
  friend class meshedit::Handle;
  friend class meshedit::Halfedge;
  friend struct Inspector;

  Tag tag_;
};

/// What an element keeps apart from itself, since few programs use it: the part that all use
/// then takes less memory. The element's first constructor argument is the place for it, which
/// holds zero bytes at first.
struct NothingAside {};
template <class T>
struct AsideOf {
  using Type = NothingAside;
};
template <>
struct AsideOf<Edge> {
  using Type = EdgeRecord;
};

/// Pointers to memory blocks that double in size, so that there is room for all there can be.
/// A std::vector would do, but each student's file would instantiate it once more.
template <class T>
class BlockList {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* const* begin() const { return blocks_.data(); }
  T* const* end() const { return blocks_.data() + size_; }
  T* operator[](std::size_t index) const { return blocks_[index]; }
  void push_back(T* block) { blocks_[size_++] = block; }
  void clear() { size_ = 0; }

 private:
  std::array<T*, 26> blocks_{};  // 16 * (1 + 2 + ... + 2^25) elements: more than kMaxElements
  std::size_t size_ = 0;
};

template <class T>
class Pool {
  using Aside = typename AsideOf<T>::Type;
  static constexpr bool kHasAside = !std::is_same<Aside, NothingAside>::value;

 public:
  using value_type = T;
  using size_type = std::size_t;
  using iterator = Handle<T>;
  using const_iterator = Handle<const T>;

  explicit Pool(std::size_t first_place = 0) : first_place_(first_place) { set_mesh(0); }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() { clear(); }

  std::size_t size() const { return live_; }
  bool empty() const { return live_ == 0; }
  Handle<T> begin() { return Handle<T>(first()); }
  Handle<T> end() { return Handle<T>(end_address()); }
  Handle<const T> begin() const { return Handle<const T>(const_cast<Pool*>(this)->first()); }
  Handle<const T> end() const {
    return Handle<const T>(const_cast<Pool*>(this)->end_address());
  }

  /// Appends an element for the mesh numbered `mesh`. Handles to others stay valid.
  template <class... Args>
  T* append(std::uint32_t mesh, Args&&... args) {
    if (free_ == chunk_end_) add_chunk();
    T* slot = free_;
    if constexpr (kHasAside) {
      Aside& aside = *(asides_end_ - (chunk_end_ - slot));
      if constexpr (!std::is_empty_v<Added<Aside>>) ::new (static_cast<void*>(&aside)) Aside();
      ::new (static_cast<void*>(slot)) T(aside, std::forward<Args>(args)...);
    } else {
      ::new (static_cast<void*>(slot)) T(std::forward<Args>(args)...);
    }
    slot->tag_ = Tag(SlotState::kLive, first_place_ + used_, mesh, KindOf<T>::kValue);
    set_mesh(mesh);
    ++free_;
    ++used_;
    ++live_;
    if (free_ != chunk_end_) link_at(free_).set(SlotState::kLink, 0, mesh, &end_);
    return slot;
  }

  /// Marks a live element as deleted. Its slot stays, so that old handles can be told.
  void remove(T* element) {
    element->tag_ = Tag(SlotState::kDeleted, element->tag_.index(), element->tag_.mesh());
    --live_;
  }

  // Like std::list, for functions that go to the lists themselves. New elements always come
  // last, whatever the place that insert() is given.
  Handle<T> insert(const Handle<const T>& /*place*/, const T& value) {
    return Handle<T>(append(mesh(), value));
  }
  void push_back(const T& value) { append(mesh(), value); }
  template <class... Args>
  T& emplace_back(Args&&... args) {
    return *append(mesh(), std::forward<Args>(args)...);
  }
  Handle<T> erase(const Handle<T>& handle) {
    Handle<T> after = handle;
    ++after;
    if (handle.element_->tag_.mesh() != mesh()) {
      raise_fault(FaultKind::kForeignHandle, T::kHandleName);
    }
    remove(handle.element_);
    return after;
  }
  T& front() { return *begin(); }
  T& back() { return *--end(); }
  const T& front() const { return *begin(); }
  const T& back() const { return *--end(); }

  /// The mesh that the elements belong to; 0 if to none.
  std::uint32_t mesh() const { return end_.mesh(); }
  void set_mesh(std::uint32_t mesh) {
    end_.set(SlotState::kEnd, first_place_ + kMaxElements, mesh, this);
  }

  /// Destroys all elements and frees their memory.
  void clear() {
    for (std::size_t i = 0; i < used_; ++i) {
      T* slot = at(i);
      slot->tag_ = Tag(SlotState::kDeleted, slot->tag_.index(), slot->tag_.mesh());
      slot->~T();
    }
    for (T* chunk : chunks_)
      ::operator delete(static_cast<void*>(chunk - 1));
    for (Aside* asides : asides_)
      std::free(asides);
    chunks_.clear();
    asides_.clear();
    free_ = chunk_end_ = nullptr;
    used_ = live_ = 0;
  }

  /// Slots in use, live or deleted: indices run from 0 to slots() - 1.
  std::size_t slots() const { return used_; }

  /// The element with this index, live or deleted.
  T* at(std::size_t index) const { return chunks_[chunk_of(index)] + offset_of(index); }

  /// The index of the element at this address, or -1 if none of this pool is there. Never
  /// reads what the address points to.
  std::ptrdiff_t find(const void* address) const {
    const auto place = reinterpret_cast<std::uintptr_t>(address);
    for (std::size_t k = 0; k < chunks_.size(); ++k) {
      const auto base = reinterpret_cast<std::uintptr_t>(chunks_[k]);
      if (place < base || place >= base + chunk_size(k) * sizeof(T)) continue;
      const std::size_t index = chunk_size(k) - kFirstChunk + (place - base) / sizeof(T);
      const bool aligned = (place - base) % sizeof(T) == 0;
      return aligned && index < used_ ? static_cast<std::ptrdiff_t>(index) : -1;
    }
    return -1;
  }

  bool is_end(const void* address) const { return address == &end_; }

  /// The live element after this one, or the end.
  static T* next(T* element) {
    T* slot = element + 1;
    for (;;) {
      switch (slot->tag_.state()) {
        case SlotState::kLink:
          slot = static_cast<T*>(link_at(slot).target);
          break;
        case SlotState::kDeleted:
          ++slot;
          break;
        default:
          return slot;
      }
    }
  }

  /// The live element before this one or before the end; nullptr if there is none.
  static T* previous(T* element) {
    T* slot = element;
    if (element->tag_.state() == SlotState::kEnd) {
      const Pool* pool = static_cast<const Pool*>(link_at(element).target);
      if (pool->used_ == 0) return nullptr;
      slot = pool->at(pool->used_ - 1) + 1;
    }
    for (--slot;;) {
      switch (slot->tag_.state()) {
        case SlotState::kLink:
          slot = static_cast<T*>(link_at(slot).target);
          if (slot == nullptr) return nullptr;
          break;
        case SlotState::kDeleted:
          --slot;
          break;
        default:
          return slot;
      }
    }
  }

 private:
  /// Stands in a slot that holds no element. Chunks begin and end with one. Its tag is read as
  /// if it were an element's, so the compiler must not take the two for different memory.
#if defined(__GNUC__)
  struct __attribute__((may_alias)) Link : Element {
#else
  struct Link : Element {
#endif
    void* target = nullptr;

    std::uint32_t mesh() const {
      return this->tag_.mesh();
    }
    void set(SlotState state, std::size_t index, std::uint32_t mesh, void* new_target) {
      this->tag_ = Tag(state, index, mesh);
      target = new_target;
    }
  };

  static constexpr std::size_t kFirstChunk = 16;

  // Chunk k holds kFirstChunk * 2^k elements, so that index arithmetic finds the chunk.
  static std::size_t chunk_of(std::size_t index) {
    std::size_t chunk = 0;
#if defined(__GNUC__)
    chunk = static_cast<std::size_t>(63 - __builtin_clzll(index + kFirstChunk)) - 4;
#else
    for (std::size_t i = (index + kFirstChunk) / kFirstChunk; i > 1; i /= 2)
      ++chunk;
#endif
    return chunk;
  }
  static std::size_t chunk_size(std::size_t chunk) {
    return kFirstChunk << chunk;
  }
  static std::size_t offset_of(std::size_t index) {
    return index + kFirstChunk - chunk_size(chunk_of(index));
  }

  static Link& link_at(T* slot) {
    static_assert(sizeof(Link) <= sizeof(T) && alignof(Link) <= alignof(T), "links fit");
    return *reinterpret_cast<Link*>(slot);
  }

  /// calloc gives fresh pages of zeros without touching them: they cost nothing until used.
  void add_asides(std::size_t size) {
    if (asides_.size() > chunks_.size()) return;  // from a chunk for which no memory was left
    auto* asides = static_cast<Aside*>(std::calloc(size, sizeof(Aside)));
    if (asides == nullptr) throw std::bad_alloc();
    asides_.push_back(asides);
    asides_end_ = asides + size;
  }

  void add_chunk() {
    const std::size_t size = chunk_size(chunks_.size());
    if (used_ + size > kMaxElements) throw std::bad_alloc();
    if constexpr (kHasAside) add_asides(size);
    T* before = static_cast<T*>(::operator new((size + 2) * sizeof(T)));
    T* chunk = before + 1;
    T* previous_last = chunks_.empty() ? nullptr : at(used_ - 1);
    ::new (static_cast<void*>(before)) Link();
    ::new (static_cast<void*>(chunk + size)) Link();
    link_at(before).set(SlotState::kLink, 0, 0, previous_last);
    link_at(chunk + size).set(SlotState::kLink, 0, 0, &end_);
    if (previous_last != nullptr) link_at(previous_last + 1).target = chunk;
    chunks_.push_back(chunk);
    free_ = chunk;
    chunk_end_ = chunk + size;
  }

  T* first() {
    if (used_ == 0) return end_address();
    T* slot = at(0);
    return slot->tag_.state() == SlotState::kLive ? slot : next(slot);
  }
  T* end_address() {
    return reinterpret_cast<T*>(&end_);
  }

  BlockList<T> chunks_;
  BlockList<Aside> asides_;      // one array for each chunk
  Aside* asides_end_ = nullptr;  // where the last one ends
  T* free_ = nullptr;            // the next slot to use
  T* chunk_end_ = nullptr;       // where the last chunk ends
  std::size_t used_ = 0;
  std::size_t live_ = 0;
  std::size_t first_place_;
  Link end_;
};

}  // namespace detail
}  // namespace meshedit
