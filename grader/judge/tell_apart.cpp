#include "grader/judge/tell_apart.h"

#include <algorithm>
#include <functional>
#include <set>

namespace meshgrade {

void tell_apart(const std::vector<CaseJudgement*>& judgements) {
  std::set<std::string> certain;
  for (const CaseJudgement* judgement : judgements) {
    for (const Finding& finding : judgement->findings) {
      if (finding.likely.size() == 1) certain.insert(finding.likely[0].name);
    }
  }
  const auto is_certain = [&](const Misconception& m) { return certain.count(m.name) != 0; };
  for (CaseJudgement* judgement : judgements) {
    for (Finding& finding : judgement->findings) {
      Misconceptions& likely = finding.likely;
      if (std::none_of(likely.begin(), likely.end(), is_certain)) continue;
      likely.erase(std::remove_if(likely.begin(), likely.end(), std::not_fn(is_certain)),
                   likely.end());
    }
  }
}

}  // namespace meshgrade
