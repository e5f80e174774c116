#include "meshedit/meshedit.h"
#include <algorithm>
#include <array>
#include <map>
namespace meshedit {
// A soup of corners with coordinates only; welded again by (old vertex pair); a new mesh is made
// and assigned; the old handles die.
using Key = std::pair<Index, Index>;
void MeshResampler::upsample(HalfedgeMesh& mesh) try {
  std::map<VertexCIter, Index> id;
  std::vector<Vector3D> P;
  for (VertexCIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) { id.insert({v, P.size()}); P.push_back(v->position); }
  std::vector<std::array<Index, 3>> T;
  for (FaceCIter f = mesh.facesBegin(); f != mesh.facesEnd(); ++f) {
    HalfedgeCIter h = f->halfedge();
    T.push_back({id[h->vertex()], id[h->next()->vertex()], id[h->next()->next()->vertex()]});
  }
  std::map<Key, std::vector<Index>> far;                      // edge -> opposite corners
  for (auto& t : T) for (int i = 0; i < 3; ++i) far[std::minmax(t[i], t[(i + 1) % 3])].push_back(t[(i + 2) % 3]);
  std::vector<std::vector<Index>> nb(P.size()), rim(P.size());
  std::map<Key, Index> mid;
  std::vector<Vector3D> Q(P.size());
  for (auto& [k, o] : far) {
    auto [a, b] = k;
    nb[a].push_back(b); nb[b].push_back(a);
    if (o.size() == 1) { rim[a].push_back(b); rim[b].push_back(a); }
    mid[k] = Q.size();
    Q.push_back(o.size() == 1 ? (P[a] + P[b]) / 2 : 3. / 8 * (P[a] + P[b]) + 1. / 8 * (P[o[0]] + P.at(o.at(1))));
  }
  for (Index i = 0; i < P.size(); ++i) {
    auto& list = rim[i].empty() ? nb[i] : rim[i];
    double w = !rim[i].empty() ? 1. / 8 : list.size() == 3 ? 3. / 16 : 3. / 8 / double(list.size());
    Q[i] = P[i];
    for (Index j : list) Q[i] += w * (P[j] - P[i]);
  }
  std::vector<std::vector<Index>> out;
  for (auto& t : T) {
    Index m[3];
    for (int i = 0; i < 3; ++i) m[i] = mid.at(std::minmax(t[i], t[(i + 1) % 3]));
    for (int i = 0; i < 3; ++i) out.insert(out.begin() + (out.size() / 2), std::vector<Index>{t[i], m[i], m[(i + 2) % 3]});
    out.push_back({m[2], m[0], m[1]});
  }
  HalfedgeMesh fresh;
  fresh.build(out, Q);
  mesh = fresh;
} catch (const MeshError& e) {
  std::cerr << e.what();
  throw;
}
}
