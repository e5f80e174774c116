#pragma once

#include <string>
#include <string_view>

namespace meshgrade {

/// A text file as UTF-8 without a byte order mark, whichever of UTF-8 and UTF-16 its mark
/// tells. Without a mark the bytes stay as they are. Broken pairs of UTF-16 become '?'.
class Utf8Text {
 public:
  /// `bytes` must live as long as this.
  explicit Utf8Text(std::string_view bytes);
  Utf8Text(const Utf8Text&) = delete;
  Utf8Text& operator=(const Utf8Text&) = delete;

  std::string_view view() const { return view_; }

 private:
  std::string converted_;
  std::string_view view_;
};

}  // namespace meshgrade
