#pragma once

// What was compiled once need not be compiled again.

#include <optional>
#include <string>

#include "grader/build/build.h"

namespace meshgrade {

/// What a build would come from; empty where nothing is kept.
BuildOrigin origin_of(const Submission& submission, const Home& home, const Limits& limits,
                      BuildKind kind);

/// Digest of what can have a part in these functions ("HalfedgeMesh::flipEdge"); of everything
/// if none is named.
std::string identity_of(const BuildOrigin& origin, const std::vector<std::string>& functions);

/// The build of this origin, out of what the home has kept.
std::optional<Build> find_kept_build(const Home& home, const BuildOrigin& origin,
                                     BuildKind kind);

/// Keeps a build if the same submission would be built the same again: not where a compiler
/// broke or a file took too long.
void keep_build(const Build& build);

/// One run of the compiler: what it said, and the object that it made.
struct CompiledUnit {
  std::string messages;
  std::string object;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(messages, object);
  }
};

/// Objects of earlier builds of about the same files.
class KeptObjects {
 public:
  KeptObjects(const Submission& submission, const Home& home, BuildKind kind);

  /// @param spliced  the files that the grader's own headers take in, if any
  std::optional<CompiledUnit> find(const std::vector<SourceFile>& unit,
                                   const std::vector<SourceFile>& spliced) const;
  void keep(const std::vector<SourceFile>& unit, const std::vector<SourceFile>& spliced,
            const CompiledUnit& compiled) const;

  /// The files that this one was compiled together with: their digests, in order. Empty if it
  /// is new.
  std::vector<std::string> unit_of(const SourceFile& file) const;
  /// Of a file, as in unit_of().
  std::string digest_of(const SourceFile& file) const;

 private:
  std::string key_of(const std::vector<SourceFile>& unit,
                     const std::vector<SourceFile>& spliced) const;

  std::shared_ptr<const KeptWork> kept_;
  std::string surroundings_;
};

}  // namespace meshgrade
