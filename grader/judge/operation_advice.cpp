#include "grader/judge/operation_advice.h"

#include <array>
#include <map>
#include <set>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

struct CountedKind {
  const char* name;
  const char* maker;
  std::size_t Counts::*number;
};

constexpr std::array<CountedKind, 5> kCountedKinds{
    {{"vertex", "newVertex", &Counts::vertices},
     {"edge", "newEdge", &Counts::edges},
     {"face", "newFace", &Counts::faces},
     {"half-edge", "newHalfedge", &Counts::halfedges},
     {"boundary loop", "newBoundary", &Counts::boundaries}}};

std::string number_of(std::size_t count, const char* name) {
  const bool vertices = std::string(name) == "vertex" && count != 1;
  return vertices ? std::to_string(count) + " vertices" : plural(count, name);
}

}  // namespace

std::string count_advice(const Counts& expected, const Counts& actual) {
  std::vector<std::string> parts;
  for (const CountedKind& kind : kCountedKinds) {
    const std::size_t want = expected.*kind.number;
    const std::size_t have = actual.*kind.number;
    if (have > want) {
      parts.push_back(number_of(have - want, kind.name) + " left over: take a call of " +
                      kind.maker + " away, and use the old element in its place");
    } else if (have < want) {
      parts.push_back(number_of(want - have, kind.name) + " missing: is " + kind.maker +
                      " called for each one that is new?");
    }
  }
  return join(parts, "; ");
}

bool is_about(const std::string& rule, const std::string& pointer) {
  static const std::map<std::string, std::set<std::string>> rules{
      {"next", {"next-permutation", "next-face", "face-loop", "twin-opposite"}},
      {"twin", {"twin-involution", "twin-edge", "twin-opposite", "vertex-fan"}},
      {"vertex", {"twin-opposite", "vertex-fan", "anchor", "along-edge"}},
      {"edge", {"twin-edge", "anchor"}},
      {"face", {"next-face", "face-loop", "boundary", "anchor"}},
      {"halfedge", {"anchor", "along-edge", "face-loop", "vertex-fan"}},
  };
  // A mesh that keeps its rules and is another one can be so by any pointer.
  static const std::set<std::string> of_any{"live-pointer", "surface", "identity",
                                            "orientation",  "simple",  "counts"};
  const auto found = rules.find(pointer.substr(pointer.rfind('.') + 1));
  return of_any.count(rule) != 0 || (found != rules.end() && found->second.count(rule) != 0);
}

std::string exchange_advice(const std::vector<WrongPointer>& wrong) {
  if (wrong.size() != 2) return {};
  const auto element = [](const std::string& text) { return text.substr(0, text.find(' ')); };
  const std::string half_edge = wrong[0].name.substr(0, wrong[0].name.find('.'));
  const std::set<std::string> names{wrong[0].name, wrong[1].name};
  const bool exchanged = names == std::set{half_edge + ".next", half_edge + ".twin"} &&
                         element(wrong[0].expected) == element(wrong[1].actual) &&
                         element(wrong[1].expected) == element(wrong[0].actual);
  if (!exchanged) return {};
  return half_edge + ".next and " + half_edge +
         ".twin are exchanged: setNeighbors takes next, twin, vertex, edge, face, in this "
         "order";
}

const Misconceptions& split_misconceptions() {
  static const Misconceptions known{
      {"midpoint-at-an-end",
       "the new vertex lies on an end of the edge: its position is (b + c) / 2"},
      {"midpoint-at-origin",
       "the position of the new vertex is never set, or 1 / 2 is divided as whole numbers and "
       "becomes 0: write (b + c) / 2.0"},
      {"midpoint-not-halved", "this is b + c: the sum of the ends is not halved"},
      {"anchor-on-new-edge",
       "the half-edge of the new vertex is one of a new edge to a vertex opposite: take one "
       "that lies along the edge that was split"},
  };
  return known;
}

Misconceptions recognize_midpoint(const MeshDump& before, const Diamond& diamond,
                                  const Point3& actual, double allowed) {
  const Point3& b = before.vertices[diamond.b].position;
  const Point3& c = before.vertices[diamond.c].position;
  const std::vector<Prediction<Point3>> predictions{
      {"midpoint-at-an-end", {b}},
      {"midpoint-at-an-end", {c}},
      {"midpoint-at-origin", {Point3{}}},
      {"midpoint-not-halved", {{b[0] + c[0], b[1] + c[1], b[2] + c[2]}}}};
  return recognize(split_misconceptions(), predictions, {actual}, allowed);
}

}  // namespace meshgrade
