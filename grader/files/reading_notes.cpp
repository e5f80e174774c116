#include "grader/files/reading_notes.h"

#include <algorithm>

#include "grader/files/file_bytes.h"

namespace meshgrade {
namespace {

bool has_twice(std::vector<std::uint32_t> corners) {
  std::sort(corners.begin(), corners.end());
  return std::adjacent_find(corners.begin(), corners.end()) != corners.end();
}

/// Takes out corners that repeat their neighbour, the last and the first being neighbours.
void merge_neighbours(std::vector<std::uint32_t>& corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.front() == corners.back())
    corners.pop_back();
}

}  // namespace

std::string place_in_words(const std::string& place) {
  const bool is_line = !place.empty() && place.find_first_not_of("0123456789") == place.npos;
  return is_line ? "line " + place : place;
}

void ReadingNotes::left_out(const std::string& one, const std::string& many,
                            const std::string& place, std::size_t count) {
  if (count == 0) return;
  auto kind = std::find_if(kinds_.begin(), kinds_.end(),
                           [&](const Kind& known) { return known.one == one; });
  if (kind == kinds_.end()) {
    kinds_.push_back({one, many, place, 0});
    kind = kinds_.end() - 1;
  }
  kind->count += count;
}

void ReadingNotes::add(const ReadingNotes& others) {
  for (const Kind& kind : others.kinds_)
    left_out(kind.one, kind.many, kind.first_place, kind.count);
  said_.insert(said_.end(), others.said_.begin(), others.said_.end());
}

std::vector<std::string> ReadingNotes::all() const {
  std::vector<std::string> notes;
  for (const Kind& kind : kinds_) {
    std::string note = "left out " + std::to_string(kind.count) + ' ' +
                       (kind.count == 1 ? kind.one : kind.many);
    if (!kind.first_place.empty()) {
      note += kind.count == 1 ? ", at " : ", the first at ";
      note += place_in_words(kind.first_place);
    }
    notes.push_back(std::move(note));
  }
  notes.insert(notes.end(), said_.begin(), said_.end());
  return notes;
}

bool admit_polygon(const std::filesystem::path& file, const std::string& place,
                   std::size_t face, std::vector<std::uint32_t>& corners,
                   std::size_t n_vertices, unsigned first_number, ReadingNotes& notes) {
  for (const std::uint32_t v : corners)
    check_corner(file, place, face, v, n_vertices, first_number);
  const std::size_t n_named = corners.size();
  if (n_named < 3) {
    notes.left_out("face with fewer than 3 corners", "faces with fewer than 3 corners", place);
    return false;
  }
  merge_neighbours(corners);
  if (corners.size() < 3 || has_twice(corners)) {
    notes.left_out("face without area (a corner twice)", "faces without area (a corner twice)",
                   place);
    return false;
  }
  if (corners.size() < n_named) {
    notes.left_out("corner that repeats the one before it",
                   "corners that repeat the one before them", place, n_named - corners.size());
  }
  return true;
}

}  // namespace meshgrade
