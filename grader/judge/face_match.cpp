#include "grader/judge/face_match.h"

#include <algorithm>
#include <set>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

/// Searches for the vertices of the free labels. Faces with many known corners go first, so
/// that there is hardly anything to try.
class FreeLabelSearch {
 public:
  FreeLabelSearch(const Answer& answer, std::vector<Corners> asked, std::vector<Corners> there)
      : answer_(answer),
        asked_(std::move(asked)),
        there_(std::move(there)),
        is_asked_(asked_.size(), true),
        is_there_(there_.size(), true) {
    for (const Corners& corners : answer.after.faces) {
      for (Label label : corners) {
        if (label < answer.first_free) taken_.insert(label);
      }
    }
  }

  bool run() {
    const std::size_t next = best();
    if (next == asked_.size()) return true;
    is_asked_[next] = false;
    const Corners& face = asked_[next];
    for (std::size_t i = 0; i < there_.size(); ++i) {
      if (!is_there_[i] || there_[i].size() != face.size()) continue;
      is_there_[i] = false;
      for (std::size_t turn = 0; turn < face.size(); ++turn) {
        std::vector<Label> entered;
        if (pair(face, there_[i], turn, entered) && run()) return true;
        for (Label label : entered) {
          taken_.erase(map_[label]);
          map_.erase(label);
        }
      }
      is_there_[i] = true;
    }
    is_asked_[next] = true;
    return false;
  }

  LabelMap take() { return std::move(map_); }

 private:
  bool is_known(Label label) const {
    return label < answer_.first_free || map_.count(label) != 0;
  }

  /// The open face with the most known corners; the number of faces if none is open.
  std::size_t best() const {
    std::size_t best = asked_.size();
    std::ptrdiff_t most = -1;
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      if (!is_asked_[i]) continue;
      const auto known = std::count_if(asked_[i].begin(), asked_[i].end(),
                                       [&](Label label) { return is_known(label); });
      if (known <= most) continue;
      most = known;
      best = i;
    }
    return best;
  }

  bool pair(const Corners& face, const Corners& vertices, std::size_t turn,
            std::vector<Label>& entered) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Label label = face[k];
      const Ref vertex = vertices[(k + turn) % vertices.size()];
      if (is_known(label)) {
        const Ref known = label < answer_.first_free ? label : map_.at(label);
        if (known != vertex) return false;
      } else {
        if (!taken_.insert(vertex).second) return false;
        map_[label] = vertex;
        entered.push_back(label);
      }
    }
    return true;
  }

  const Answer& answer_;
  std::vector<Corners> asked_;
  std::vector<Corners> there_;
  std::vector<bool> is_asked_;
  std::vector<bool> is_there_;
  std::set<Ref> taken_;
  LabelMap map_;
};

bool has_free(const Answer& answer, const Corners& corners) {
  return std::any_of(corners.begin(), corners.end(),
                     [&](Label label) { return label >= answer.first_free; });
}

/// Those of the answer that have no equal among the others, and those that are left of these.
struct Rest {
  std::vector<Corners> asked;
  std::vector<Corners> there;
};

Rest rest_of(const Answer& answer, const FaceLists& actual) {
  std::multiset<Corners> there;
  for (const Corners& corners : actual.faces)
    there.insert(canonical(corners));
  Rest rest;
  for (const Corners& corners : answer.after.faces) {
    const auto found = has_free(answer, corners) ? there.end() : there.find(canonical(corners));
    if (found == there.end()) {
      rest.asked.push_back(corners);
    } else {
      there.erase(found);
    }
  }
  rest.there.assign(there.begin(), there.end());
  return rest;
}

std::string text_of(const Answer& answer, const Corners& corners) {
  std::vector<std::string> names;
  for (Label label : corners)
    names.push_back(label < answer.first_free ? vertex_name(label) : "new");
  return join(names, "-");
}

}  // namespace

std::optional<LabelMap> match_faces(const Answer& answer, const FaceLists& actual) {
  Rest rest = rest_of(answer, actual);
  if (rest.asked.size() != rest.there.size()) return std::nullopt;
  const auto is_fixed = [&](const Corners& corners) { return !has_free(answer, corners); };
  if (std::any_of(rest.asked.begin(), rest.asked.end(), is_fixed)) return std::nullopt;
  FreeLabelSearch search(answer, std::move(rest.asked), std::move(rest.there));
  if (!search.run()) return std::nullopt;
  return search.take();
}

FaceDifference difference(const Answer& answer, const FaceLists& actual) {
  const Rest rest = rest_of(answer, actual);
  FaceDifference difference;
  std::multiset<Corners> there(rest.there.begin(), rest.there.end());
  difference.turned = !rest.asked.empty();
  for (const Corners& corners : rest.asked) {
    difference.missing.push_back(text_of(answer, corners));
    const Corners turned = canonical({corners.rbegin(), corners.rend()});
    difference.turned = difference.turned && there.count(turned) != 0;
  }
  for (const Corners& corners : rest.there)
    difference.surplus.push_back(text_of(answer, corners));
  return difference;
}

}  // namespace meshgrade
