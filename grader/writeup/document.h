#pragma once

// The write-up as text: the rubric's items as headings, room for the student's words, and the
// pictures with what the judge says of them.

#include <string>
#include <vector>

namespace meshgrade {

struct WriteupPicture {
  std::string file;     ///< from beside the document: "pictures/curve_0.png"
  std::string caption;  ///< what is seen
  std::string told;     ///< what went wrong, one line each; empty: nothing
};

struct WriteupPart {
  std::string heading;
  std::string asks;
  std::vector<WriteupPicture> pictures;
};

struct Writeup {
  std::string title;
  std::string submission;
  std::vector<WriteupPart> parts;
};

/// Whatever stands in the texts comes out as text, in both.
std::string to_markdown(const Writeup& writeup);
std::string to_html(const Writeup& writeup);

}  // namespace meshgrade
