#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace meshgrade {

/// What a reader has to say of a file that it reads: first of all what it leaves out, counted,
/// so that nothing goes without a word.
class ReadingNotes {
 public:
  /// `one` and `many` name the thing in singular and plural. `place` is where a message would
  /// say that it is: a line, or "byte 84", or an element of the file; it may be empty.
  void left_out(const std::string& one, const std::string& many, const std::string& place,
                std::size_t count = 1);
  void say(const std::string& note) { said_.push_back(note); }
  /// Adds those of a part of the file.
  void add(const ReadingNotes& others);

  /// One for each kind of thing, "left out 3 lines, the first at line 17", then what was said.
  std::vector<std::string> all() const;

 private:
  struct Kind {
    std::string one;
    std::string many;
    std::string first_place;
    std::size_t count = 0;
  };
  std::vector<Kind> kinds_;
  std::vector<std::string> said_;
};

/// "line 17" for "17", which is how the place in a text file is told; others as they are.
std::string place_in_words(const std::string& place);

/// Makes the corners that a file names a polygon that a mesh can hold. A corner that repeats
/// the one before it goes. False if fewer than three are left or one still comes twice: such a
/// face has no area, or none that can be told, and is counted in `notes`. Throws UserError
/// if a corner is not below `n_vertices`; `first_number` is the number that the format gives
/// to its first vertex.
bool admit_polygon(const std::filesystem::path& file, const std::string& place,
                   std::size_t face, std::vector<std::uint32_t>& corners,
                   std::size_t n_vertices, unsigned first_number, ReadingNotes& notes);

}  // namespace meshgrade
