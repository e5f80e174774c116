#pragma once

// The bytes that travel between the grader and the worker. Both run on the same machine, so
// numbers go as they are in memory. Written for C++17, because the worker is built like student
// code.

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace meshgrade {

/// The bytes do not have the form that was agreed on.
class WireError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Packs values one after the other. A struct takes part by a member function
/// `template <class Wire> void transfer(Wire& wire) { wire(a, b, c); }`.
class WireWriter {
 public:
  template <class... Ts>
  void operator()(const Ts&... values) {
    (put(values), ...);
  }

  const std::string& bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    if (size != 0) bytes_.append(static_cast<const char*>(data), size);
  }

  template <class T>
  void put(const T& value) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      append(&value, sizeof value);
    } else {
      const_cast<T&>(value).transfer(*this);
    }
  }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    append(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    if constexpr (std::is_trivially_copyable_v<T>) {
      append(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values)
        put(value);
    }
  }

  std::string bytes_;
};

/// Unpacks what a WireWriter packed. Never reads past the end and never allocates more than the
/// bytes could hold.
class WireReader {
 public:
  explicit WireReader(std::string_view bytes) : rest_(bytes) {}

  /// @throws WireError when the bytes end too early
  template <class... Ts>
  void operator()(Ts&... values) {
    (get(values), ...);
  }

  template <class T>
  T read() {
    T value{};
    get(value);
    return value;
  }

  bool at_end() const { return rest_.empty(); }

  /// @throws WireError when bytes are left over
  void expect_end() const {
    if (!rest_.empty()) {
      throw WireError(std::to_string(rest_.size()) + " bytes more than expected");
    }
  }

 private:
  void copy(void* to, std::uint64_t size) {
    if (size > rest_.size()) throw WireError("the bytes end too early");
    if (size != 0) std::memcpy(to, rest_.data(), static_cast<std::size_t>(size));
    rest_.remove_prefix(static_cast<std::size_t>(size));
  }

  template <class T>
  void get(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      copy(&value, sizeof value);
    } else {
      value.transfer(*this);
    }
  }
  void get(bool& value) {
    unsigned char byte = 0;
    copy(&byte, 1);
    if (byte > 1) throw WireError("neither true nor false");
    value = byte == 1;
  }
  std::uint64_t get_count(std::size_t least_size) {
    std::uint64_t count = 0;
    get(count);
    if (count > rest_.size() / least_size) throw WireError("a list longer than the bytes");
    return count;
  }
  void get(std::string& text) {
    text.resize(static_cast<std::size_t>(get_count(1)));
    copy(text.data(), text.size());
  }
  template <class T>
  void get(std::vector<T>& values) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      values.resize(static_cast<std::size_t>(get_count(sizeof(T))));
      copy(values.data(), values.size() * sizeof(T));
    } else {
      const std::uint64_t count = get_count(1);
      values.clear();
      for (std::uint64_t i = 0; i < count; ++i)
        get(values.emplace_back());
    }
  }

  std::string_view rest_;
};

/// The bytes of one value.
template <class T>
std::string to_wire(const T& value) {
  WireWriter writer;
  writer(value);
  return writer.take();
}

/// @throws WireError unless the bytes are exactly one T
template <class T>
T from_wire(std::string_view bytes) {
  WireReader reader(bytes);
  T value = reader.template read<T>();
  reader.expect_end();
  return value;
}

}  // namespace meshgrade
