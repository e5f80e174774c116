#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "grader/files/ply_header.h"
#include "grader/files/reading_notes.h"
#include "grader/files/text_scanner.h"

namespace meshgrade {

/// Gives the numbers of a PLY file behind its header one by one.
class PlyBody {
 public:
  virtual ~PlyBody() = default;
  /// Goes to the next element; `name` says in messages which it is.
  virtual void begin_element(const std::string& name) = 0;
  /// Finite for a type of floats, else a whole number. It is of this property of the element.
  virtual double next(const PlyScalar& type, const PlyProperty& property) = 0;
  /// Passes over a number of which nothing is wanted, so that it may be anything.
  virtual void skip(const PlyScalar& type) = 0;
  virtual void end_element(ReadingNotes& notes) = 0;
  /// Counts what stands behind the last element.
  virtual void end(ReadingNotes& notes) = 0;
  /// Of the element.
  virtual std::string place() const = 0;
};

/// The body behind the header that `scanner` has just read from `bytes`.
std::unique_ptr<PlyBody> open_ply_body(const std::filesystem::path& file,
                                       std::string_view bytes, PlyEncoding encoding,
                                       const TextScanner& scanner);

}  // namespace meshgrade
