#pragma once

// Small submissions, built and run like a student's.

#include "grader/build/build.h"
#include "grader/run/run.h"

namespace meshgrade {

inline Home test_home() {
  const std::filesystem::path source = MESHGRADE_SOURCE_DIR;
  static const Sandbox sandbox = find_sandbox(MESHGRADE_KIT_DIR, MESHGRADE_COMPILER);
  return {source / "include",   MESHGRADE_KIT_DIR,  source / "meshes", source / "docs",
          source / "reference", MESHGRADE_COMPILER, sandbox,           nullptr};
}

inline Submission submission_of(std::vector<SourceFile> sources,
                                std::vector<SourceFile> headers = {}) {
  Submission submission;
  submission.name = "test";
  submission.sources = std::move(sources);
  submission.headers = std::move(headers);
  return submission;
}

inline Build build_sources(std::vector<SourceFile> sources,
                           std::vector<SourceFile> headers = {}) {
  return build_submission(submission_of(std::move(sources), std::move(headers)), test_home(),
                          Limits{});
}

/// A student's normal.cpp: `helpers` at the top, `body` in Vertex::normal, which begins in line
/// 5 when there are no newlines in the helpers.
inline SourceFile normal_file(const std::string& body, const std::string& helpers = "") {
  return {"normal.cpp", "#include \"meshedit/meshedit.h\"\n" + helpers +
                            "\nnamespace meshedit {\nVector3D Vertex::normal() const {\n" +
                            body + "\n}\n}\n"};
}

}  // namespace meshgrade
