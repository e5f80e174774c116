#include "grader/judge/label_choice.h"

#include <algorithm>

#include "grader/base/contains.h"

namespace meshgrade {
namespace {

class LabelSearch {
 public:
  LabelSearch(const std::vector<WantedLabel>& wanted, const std::vector<Ref>& available)
      : wanted_(wanted), current_(wanted.size(), kUnsetRef) {
    for (const WantedLabel& w : wanted)
      options_.push_back(options_of(w, available));
  }

  void run(std::vector<Ref>& chosen) {
    decide(0, 0);
    chosen = best_;
  }

  std::size_t cost() const { return best_cost_; }

 private:
  /// Whoever is named by no half-edge and anchors none is as good as nobody.
  static std::vector<Ref> options_of(const WantedLabel& w, const std::vector<Ref>& available) {
    std::vector<Ref> options;
    for (const auto* list : {&w.named, &w.anchoring}) {
      for (Ref ref : *list) {
        if (contains(available, ref) && !contains(options, ref)) options.push_back(ref);
      }
    }
    // An old element that keeps its place comes first, where there is a choice.
    std::stable_partition(options.begin(), options.end(),
                          [&](Ref ref) { return ref == w.element; });
    return options;
  }

  static std::size_t cost_of(const WantedLabel& w, Ref label) {
    const auto agreeing = std::count(w.named.begin(), w.named.end(), label);
    return w.named.size() - static_cast<std::size_t>(agreeing) +
           (contains(w.anchoring, label) ? 0 : 1);
  }

  void decide(std::size_t i, std::size_t cost) {
    if (cost >= best_cost_) return;
    if (i == wanted_.size()) {
      best_cost_ = cost;
      best_ = current_;
      return;
    }
    for (Ref label : options_[i]) {
      if (contains(current_, label)) continue;
      current_[i] = label;
      decide(i + 1, cost + cost_of(wanted_[i], label));
      current_[i] = kUnsetRef;
    }
    decide(i + 1, cost + wanted_[i].named.size() + 1);
  }

  const std::vector<WantedLabel>& wanted_;
  std::vector<std::vector<Ref>> options_;
  std::vector<Ref> current_;
  std::vector<Ref> best_;
  std::size_t best_cost_ = SIZE_MAX;
};

/// What is left over stands for what has found nobody: an element that is there and wrong is
/// told better than one that is missing.
void hand_out_the_rest(const std::vector<WantedLabel>& wanted,
                       const std::vector<Ref>& available, std::vector<Ref>& chosen) {
  std::vector<Ref> rest;
  for (Ref ref : available) {
    if (!contains(chosen, ref)) rest.push_back(ref);
  }
  for (std::size_t i = 0; i < wanted.size() && !rest.empty(); ++i) {
    if (chosen[i] != kUnsetRef) continue;
    auto next = std::find(rest.begin(), rest.end(), wanted[i].element);
    if (next == rest.end()) next = rest.begin();
    chosen[i] = *next;
    rest.erase(next);
  }
}

}  // namespace

std::size_t choose_labels(const std::vector<WantedLabel>& wanted,
                          const std::vector<Ref>& available, std::vector<Ref>& chosen) {
  LabelSearch choice(wanted, available);
  choice.run(chosen);
  hand_out_the_rest(wanted, available, chosen);
  return choice.cost();
}

}  // namespace meshgrade
