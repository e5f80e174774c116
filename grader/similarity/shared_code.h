#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "grader/similarity/code_tokens.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// Two hand-ins that have code in common: so many percent of the one's are in the other. What
/// many of the class have counts less than what only these two have.
struct SimilarPair {
  std::string first;
  std::string second;
  int of_first = 0;
  int of_second = 0;
  std::size_t first_at = 0;  ///< the place of the hand-in among all
  std::size_t second_at = 0;

  int most() const { return of_first > of_second ? of_first : of_second; }
  /// By which pairs are ranked: a chance finds its way into one of them more easily than into
  /// both.
  int rank() const { return of_first + of_second; }
};

/// The files that count of one hand-in.
struct HandInText {
  std::string key;
  std::vector<SourceFile> files;
};

/// A part of a file.
struct TextRange {
  std::size_t begin = 0;  ///< in bytes
  std::size_t end = 0;
};

/// Finds runs of tokens that several hand-ins have, wherever they stand: the order of functions
/// and how they are shared out to files make no difference. (All runs of `least_tokens` are
/// compared: with some thousand of them in a hand-in there is no need to choose fingerprints,
/// as in "Winnowing" by Schleimer, Wilkerson and Aiken, SIGMOD 2003.)
class SharedCode {
 public:
  /// @param handed_out    what does not count
  /// @param least_tokens  a shorter run of equal tokens is chance
  SharedCode(std::vector<HandInText> texts, const std::vector<SourceFile>& handed_out,
             std::size_t least_tokens);

  const std::vector<HandInText>& texts() const { return texts_; }

  /// All pairs of which at least `least_percent` of one are in the other, the most similar
  /// first.
  std::vector<SimilarPair> pairs(int least_percent) const;

  /// What `of` has in common with `with`, for each file of `of`, in order and apart.
  std::vector<std::vector<TextRange>> shared_parts(std::size_t of, std::size_t with) const;

 private:
  /// A run of tokens: where it begins, and what it is.
  struct Run {
    std::uint64_t hash = 0;
    std::size_t file = 0;
    std::size_t token = 0;  ///< in the file
  };
  struct HandIn {
    std::vector<std::vector<CodeToken>> files;
    std::vector<Run> runs;              ///< that count, by hash
    std::vector<std::uint64_t> sorted;  ///< their hashes, each once
    double own_weight = 0.0;            ///< of all tokens in runs that count
  };
  using TokenWeights = std::vector<std::vector<double>>;  ///< by file and token

  std::vector<Run> runs_of(const std::vector<std::vector<CodeToken>>& files) const;
  void count_hand_ins();
  void drop_common(const std::vector<SourceFile>& handed_out);
  double weight(std::uint64_t hash) const;
  TokenWeights shared_tokens(std::size_t of, const std::vector<std::uint64_t>& other) const;
  static double sum_of(const TokenWeights& weights);
  double share(std::size_t of, std::size_t with) const;
  std::vector<std::uint32_t> shared_runs() const;

  std::vector<HandInText> texts_;
  std::size_t length_;
  std::vector<HandIn> hand_ins_;
  std::unordered_map<std::uint64_t, std::uint32_t> spread_;  ///< hand-ins that have a run
};

/// Hand-ins that belong together by pairs of at least `least_percent`: two or more each, the
/// largest group first. Keys as in the pairs.
std::vector<std::vector<std::string>> groups_of(const std::vector<SimilarPair>& pairs,
                                                int least_percent);

}  // namespace meshgrade
