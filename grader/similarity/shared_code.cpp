#include "grader/similarity/shared_code.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_set>

namespace meshgrade {
namespace {

/// What more than this part of a class has is how everybody writes it.
constexpr double kCommon = 0.2;
/// In classes smaller than that nobody can tell what is common.
constexpr std::size_t kSmallClass = 10;

std::vector<std::uint64_t> each_once(std::vector<std::uint64_t> hashes) {
  std::sort(hashes.begin(), hashes.end());
  hashes.erase(std::unique(hashes.begin(), hashes.end()), hashes.end());
  return hashes;
}

}  // namespace

SharedCode::SharedCode(std::vector<HandInText> texts, const std::vector<SourceFile>& handed_out,
                       std::size_t least_tokens)
    : texts_(std::move(texts)), length_(std::max<std::size_t>(least_tokens, 1)) {
  for (const HandInText& text : texts_) {
    HandIn& hand_in = hand_ins_.emplace_back();
    for (const SourceFile& file : text.files)
      hand_in.files.push_back(code_tokens(file.text));
    hand_in.runs = runs_of(hand_in.files);
  }
  count_hand_ins();
  drop_common(handed_out);
  for (std::size_t i = 0; i < hand_ins_.size(); ++i)
    hand_ins_[i].own_weight = sum_of(shared_tokens(i, hand_ins_[i].sorted));
}

std::vector<SharedCode::Run> SharedCode::runs_of(
    const std::vector<std::vector<CodeToken>>& files) const {
  constexpr std::uint64_t kBase = 1099511628211ULL;
  std::vector<Run> runs;
  for (std::size_t f = 0; f < files.size(); ++f) {
    const std::vector<CodeToken>& tokens = files[f];
    for (std::size_t i = 0; i + length_ <= tokens.size(); ++i) {
      std::uint64_t hash = 0;
      for (std::size_t k = i; k < i + length_; ++k)
        hash = hash * kBase + tokens[k].what;
      runs.push_back({hash, f, i});
    }
  }
  return runs;
}

void SharedCode::count_hand_ins() {
  for (HandIn& hand_in : hand_ins_) {
    for (const Run& run : hand_in.runs)
      hand_in.sorted.push_back(run.hash);
    hand_in.sorted = each_once(std::move(hand_in.sorted));
    for (std::uint64_t hash : hand_in.sorted)
      ++spread_[hash];
  }
}

/// Takes out of all hand-ins what was handed out, and what too many of them have.
void SharedCode::drop_common(const std::vector<SourceFile>& handed_out) {
  std::unordered_set<std::uint64_t> given;
  for (const SourceFile& file : handed_out) {
    for (const Run& run : runs_of({code_tokens(file.text)}))
      given.insert(run.hash);
  }
  const double most = hand_ins_.size() < kSmallClass
                          ? static_cast<double>(hand_ins_.size())
                          : std::max(3.0, kCommon * static_cast<double>(hand_ins_.size()));
  const auto is_common = [&](std::uint64_t hash) {
    return given.count(hash) != 0 || spread_.at(hash) > most;
  };
  for (HandIn& hand_in : hand_ins_) {
    auto& runs = hand_in.runs;
    runs.erase(std::remove_if(runs.begin(), runs.end(),
                              [&](const Run& run) { return is_common(run.hash); }),
               runs.end());
    auto& sorted = hand_in.sorted;
    sorted.erase(std::remove_if(sorted.begin(), sorted.end(), is_common), sorted.end());
    std::stable_sort(runs.begin(), runs.end(),
                     [](const Run& a, const Run& b) { return a.hash < b.hash; });
  }
}

/// 1 for what one or two hand-ins have, and less the more have it.
double SharedCode::weight(std::uint64_t hash) const {
  const double all = static_cast<double>(hand_ins_.size());
  if (hand_ins_.size() < kSmallClass) return 1.0;
  return std::min(1.0, std::log(all / spread_.at(hash)) / std::log(all / 2.0));
}

SharedCode::TokenWeights SharedCode::shared_tokens(
    std::size_t of, const std::vector<std::uint64_t>& other) const {
  const HandIn& mine = hand_ins_[of];
  TokenWeights weights;
  for (const std::vector<CodeToken>& file : mine.files)
    weights.emplace_back(file.size(), 0.0);
  auto next = other.begin();
  for (const Run& run : mine.runs) {
    while (next != other.end() && *next < run.hash)
      ++next;
    if (next == other.end()) break;
    if (*next != run.hash) continue;
    const double w = weight(run.hash);
    for (std::size_t i = run.token; i < run.token + length_; ++i)
      weights[run.file][i] = std::max(weights[run.file][i], w);
  }
  return weights;
}

double SharedCode::sum_of(const TokenWeights& weights) {
  double sum = 0.0;
  for (const std::vector<double>& file : weights)
    sum = std::accumulate(file.begin(), file.end(), sum);
  return sum;
}

double SharedCode::share(std::size_t of, std::size_t with) const {
  const double all = hand_ins_[of].own_weight;
  return all == 0.0 ? 0.0 : sum_of(shared_tokens(of, hand_ins_[with].sorted)) / all;
}

/// For each pair, by first * count + second, how many runs both have.
std::vector<std::uint32_t> SharedCode::shared_runs() const {
  const std::size_t count = hand_ins_.size();
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> owners;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::uint64_t hash : hand_ins_[i].sorted) {
      if (spread_.at(hash) > 1) owners[hash].push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::vector<std::uint32_t> shared(count * count);
  for (const auto& [hash, who] : owners) {
    for (std::size_t a = 0; a < who.size(); ++a) {
      for (std::size_t b = a + 1; b < who.size(); ++b)
        ++shared[who[a] * count + who[b]];
    }
  }
  return shared;
}

std::vector<SimilarPair> SharedCode::pairs(int least_percent) const {
  const std::size_t count = hand_ins_.size();
  const std::vector<std::uint32_t> shared = shared_runs();
  std::vector<SimilarPair> found;
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      if (shared[a * count + b] == 0) continue;
      SimilarPair pair{texts_[a].key, texts_[b].key, 0, 0, a, b};
      pair.of_first = static_cast<int>(std::lround(100.0 * share(a, b)));
      pair.of_second = static_cast<int>(std::lround(100.0 * share(b, a)));
      if (pair.most() >= std::max(1, least_percent)) found.push_back(std::move(pair));
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const SimilarPair& a, const SimilarPair& b) {
    return a.rank() > b.rank();
  });
  return found;
}

std::vector<std::vector<TextRange>> SharedCode::shared_parts(std::size_t of,
                                                             std::size_t with) const {
  const TokenWeights weights = shared_tokens(of, hand_ins_[with].sorted);
  std::vector<std::vector<TextRange>> parts(weights.size());
  for (std::size_t f = 0; f < weights.size(); ++f) {
    const std::vector<CodeToken>& tokens = hand_ins_[of].files[f];
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (weights[f][i] == 0.0) continue;
      const bool goes_on = i > 0 && weights[f][i - 1] > 0.0;
      if (!goes_on) parts[f].push_back({tokens[i].begin, 0});
      parts[f].back().end = tokens[i].end;
    }
  }
  return parts;
}

std::vector<std::vector<std::string>> groups_of(const std::vector<SimilarPair>& pairs,
                                                int least_percent) {
  std::map<std::string, std::string> parent;
  const auto root = [&](std::string key) {
    while (parent.try_emplace(key, key).first->second != key)
      key = parent[key];
    return key;
  };
  for (const SimilarPair& pair : pairs) {
    if (pair.most() >= least_percent) parent[root(pair.second)] = root(pair.first);
  }
  std::map<std::string, std::vector<std::string>> by_root;
  std::vector<std::string> keys;
  for (const auto& [key, above] : parent)
    keys.push_back(key);
  for (const std::string& key : keys)
    by_root[root(key)].push_back(key);
  std::vector<std::vector<std::string>> groups;
  for (auto& [key, members] : by_root)
    groups.push_back(std::move(members));
  std::stable_sort(groups.begin(), groups.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return groups;
}

}  // namespace meshgrade
