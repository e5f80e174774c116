#!/usr/bin/env bash
# believed: where PolyMesh::is_collapse_ok() of OpenMesh says yes, what collapse() leaves is a mesh like those that add_face() takes.
# happens: it looks at neighbours that the two ends have in common, and at boundaries, but not at faces. If a polygon has both ends as corners that are no neighbours in it, the answer is yes, and the polygon visits the vertex that is left twice.
# seen with: OpenMesh 9.0 (libopenmesh-dev 9.0-4+b1, Debian 12), a PolyMesh of a hexagon and the two quads that close it on the other side
# here: tests/operations/openmesh_collapse_test.cpp takes OpenMesh as a second opinion, but for this; grader/operations/polygon_meshes/edge_collapse.cpp refuses
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
cat >"$folder/collapse.cpp" <<'END'
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <iostream>

int main() {
  using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
  Mesh mesh;
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  std::vector<Mesh::VertexHandle> v;
  for (int i = 0; i < 6; ++i) v.push_back(mesh.add_vertex(Mesh::Point(0, 0, 0)));
  mesh.add_face({v[0], v[1], v[2], v[3], v[4], v[5]});
  mesh.add_face({v[3], v[2], v[1], v[0]});
  mesh.add_face({v[0], v[5], v[4], v[3]});
  const auto across = mesh.find_halfedge(v[0], v[3]);
  std::cout << "is_collapse_ok: " << mesh.is_collapse_ok(across) << "\n";
  mesh.collapse(across);
  for (const auto face : mesh.faces()) {
    std::cout << "face:";
    for (const auto corner : mesh.fv_range(face)) std::cout << " " << corner.idx();
    std::cout << "\n";
  }
}
END
library=$(dirname "$(find "$folder/root" -name 'libOpenMeshCore.so' | head -n 1)")
if ! c++ -std=c++17 -w "$folder/collapse.cpp" -I"$folder/root/usr/include" -L"$library" \
  -lOpenMeshCore -Wl,-rpath,"$library" -o "$folder/collapse" 2>"$folder/said"; then
  cat "$folder/said"
  echo "it does not compile here"
  exit 77
fi
"$folder/collapse" | tee "$folder/printed"
grep -q 'is_collapse_ok: 1' "$folder/printed" && grep -q 'face:.* 3 .* 3 \|face: 3 .* 3 ' \
  <(sed 's/$/ /' "$folder/printed")
