#pragma once

// Submissions that are the reference but for a line.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "grader/commands/context.h"
#include "grader/submission/submission.h"

namespace meshgrade {

inline SourceFile reference_file(const std::string& name) {
  std::ifstream stream(find_home().reference / name);
  return {name, {std::istreambuf_iterator<char>(stream), {}}};
}

/// The reference's file with this statement before the last statement of its function.
inline SourceFile spoiled(const std::string& name, const std::string& last,
                          const std::string& spoil) {
  SourceFile file = reference_file(name);
  const std::size_t at = file.text.rfind(last);
  EXPECT_NE(at, std::string::npos) << name << " has no \"" << last << "\"";
  file.text.insert(at, spoil);
  return file;
}

/// The reference's file with one text in place of another, where that stands first.
inline SourceFile altered(const std::string& name, const std::string& was,
                          const std::string& becomes) {
  SourceFile file = reference_file(name);
  const std::size_t at = file.text.find(was);
  EXPECT_NE(at, std::string::npos) << name << " has no \"" << was << "\"";
  file.text.replace(at, was.size(), becomes);
  return file;
}

}  // namespace meshgrade
