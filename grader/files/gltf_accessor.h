#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "grader/mesh/polygon_mesh.h"

namespace tinygltf {
class Model;
struct Accessor;
}  // namespace tinygltf

namespace meshgrade {

/// An accessor without a buffer stands for zeros, of which a file of a few bytes can ask for
/// any number.
constexpr std::size_t kMostUnstoredElements = 1'000'000;

/// Reads numbers of a glTF model, with every index and size checked. Every fault is a
/// UserError "<file>:<place>: ...".
class GltfAccessors {
 public:
  /// Both must live as long as this.
  GltfAccessors(const std::filesystem::path& file, const tinygltf::Model& model);

  /// Three numbers each, finite; floats, or whole numbers with KHR_mesh_quantization.
  std::vector<Point3> positions(int accessor, const std::string& place) const;
  std::vector<std::uint32_t> indices(int accessor, const std::string& place) const;
  /// All components of all elements, one element after the other; normalised where the
  /// accessor says so. `components` is how many an element must have, `what` who asks.
  std::vector<double> numbers(int accessor, std::size_t components, const std::string& what,
                              const std::string& place) const;

 private:
  const tinygltf::Accessor& checked_accessor(int index, const std::string& place) const;
  const unsigned char* checked_data(int view, std::size_t offset, std::size_t count,
                                    std::size_t size, std::size_t& stride,
                                    const std::string& place) const;
  std::vector<double> stored(int view, std::size_t offset, std::size_t count, int component,
                             std::size_t components, const std::string& place) const;
  std::vector<double> elements(const tinygltf::Accessor& accessor,
                               const std::string& place) const;
  void replace_sparse(const tinygltf::Accessor& accessor, std::size_t components,
                      std::vector<double>& values, const std::string& place) const;

  const std::filesystem::path& file_;
  const tinygltf::Model& model_;
  bool has_quantization_ = false;
};

}  // namespace meshgrade
