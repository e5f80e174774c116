#!/usr/bin/env bash
# believed: OpenMesh's CatmullClarkT smooths a vertex on a boundary like the rest of the literature: 3/4 of it and 1/8 of each neighbour along the boundary, so that the boundary is a cubic B-spline curve, which depends on nothing inside.
# happens: the weights are 2/3, 1/6 and 1/6: it takes the mean of the vertex and of the two new edge points, which lie in the middles. The corner of a unit square goes to 1/6, not to 1/8. Inside of the surface the usual rules hold.
# seen with: OpenMesh 9.0 (libopenmesh-dev 9.0-4+b1, Debian 12), one level on a square and on a grid of 2 x 2 quads
# here: who compares boundaries of Catmull-Clark with OpenMesh meets it; grader/judge/refinement_judge.cpp compares with OpenSubdiv
set -uo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for tool in apt-get dpkg-deb c++; do
  if ! command -v "$tool" >/dev/null; then
    echo "there is no $tool"
    exit 77
  fi
done
# shellcheck disable=SC2016  # apt expands it
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' |
  sed -n -e '/security/d' -e 's,/*$,,p' | head -n 1)
for package in libopenmesh1 libopenmesh-dev; do
  file=${package}_9.0-4+b1_amd64.deb
  if ! /usr/lib/apt/apt-helper download-file "$mirror/pool/main/o/openmesh/$file" \
    "$folder/$file" >/dev/null 2>&1; then
    echo "the package mirror does not have $file"
    exit 77
  fi
  dpkg-deb -x "$folder/$file" "$folder/root"
done
cat >"$folder/smooth.cpp" <<'END'
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <cstdio>

struct Doubles : OpenMesh::DefaultTraits {
  typedef OpenMesh::Vec3d Point;
  typedef OpenMesh::Vec3d Normal;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Doubles>;

// A flat grid of n x n quads.
Mesh grid(int n) {
  Mesh mesh;
  mesh.request_face_normals();
  mesh.request_vertex_normals();
  std::vector<Mesh::VertexHandle> v;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) v.push_back(mesh.add_vertex(Mesh::Point(x, y, 0)));
  const auto at = [&](int x, int y) { return v[y * (n + 1) + x]; };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      mesh.add_face({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
  return mesh;
}

int main() {
  OpenMesh::Subdivider::Uniform::CatmullClarkT<Mesh> subdivider;
  for (const int n : {1, 2}) {
    Mesh mesh = grid(n);
    mesh.set_point(mesh.vertex_handle(n == 2 ? 4 : 0), Mesh::Point(n - 1, n - 1, n - 1));
    subdivider.attach(mesh);
    subdivider(1);
    subdivider.detach();
    const auto corner = mesh.point(mesh.vertex_handle(0));
    std::printf("%d x %d: corner %.6f %.6f\n", n, n, corner[0], corner[1]);
    if (n == 2) std::printf("inner vertex %.6f\n", mesh.point(mesh.vertex_handle(4))[2]);
  }
}
END
library=$(dirname "$(find "$folder/root" -name 'libOpenMeshCore.so' | head -n 1)")
if ! c++ -std=c++17 -w "$folder/smooth.cpp" -I"$folder/root/usr/include" -L"$library" \
  -lOpenMeshCore -Wl,-rpath,"$library" -o "$folder/smooth" 2>"$folder/said"; then
  cat "$folder/said"
  echo "it does not compile here"
  exit 77
fi
"$folder/smooth" | tee "$folder/printed"
# Inside, a vertex of height 1: (1/4 + 2 * 1/2 + (4 - 3) * 1) / 4 = 9/16, as the rules say.
grep -q '^1 x 1: corner 0.166667 0.166667$' "$folder/printed" &&
  grep -q '^2 x 2: corner 0.166667 0.166667$' "$folder/printed" &&
  grep -q '^inner vertex 0.562500$' "$folder/printed"
