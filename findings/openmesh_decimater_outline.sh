#!/usr/bin/env bash
# believed: OpenMesh's decimater with ModQuadricT leaves a flat square what it is: collapses have no quadric error within the plane, and it takes those of the least error, so the outline would be the last to go.
# happens: every collapse costs nothing there, those along the outline and over its corners too: no plane stands on a boundary edge, as Garland and Heckbert (1997) advise. With half of 128 triangles left, two corners are gone and 8 of 64 units of area, and some triangles are turned over; with a quarter left, half of the area is gone.
# seen with: OpenMesh 9.0 (libopenmesh-dev 9.0-4+b1, Debian 12), DecimaterT with ModQuadricT, no limit of the error
# here: who simplifies open or partly flat meshes meets it; grader/simplify/openmesh_decimation adds a module that keeps boundaries, and ModNormalFlippingT
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
cat >"$folder/outline.cpp" <<'END'
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cstdio>

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
using Decimater = OpenMesh::Decimater::DecimaterT<Mesh>;
using Quadrics = OpenMesh::Decimater::ModQuadricT<Mesh>;

// A flat square of 8 x 8 units, two triangles in each.
Mesh square() {
  Mesh mesh;
  std::vector<Mesh::VertexHandle> v;
  for (int y = 0; y <= 8; ++y)
    for (int x = 0; x <= 8; ++x) v.push_back(mesh.add_vertex(Mesh::Point(x, y, 0)));
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const int at = 9 * y + x;
      mesh.add_face(v[at], v[at + 1], v[at + 10]);
      mesh.add_face(v[at], v[at + 10], v[at + 9]);
    }
  return mesh;
}

int main() {
  for (const int faces : {64, 32}) {
    Mesh mesh = square();
    Decimater decimater(mesh);
    Quadrics::Handle quadrics;
    decimater.add(quadrics);
    decimater.module(quadrics).unset_max_err();
    decimater.initialize();
    decimater.decimate_to_faces(0, faces);
    int corners = 0;
    for (const int corner : {0, 8, 72, 80})
      corners += mesh.status(mesh.vertex_handle(corner)).deleted() ? 0 : 1;
    mesh.garbage_collection();
    double area = 0.0;
    double covered = 0.0;
    for (const auto face : mesh.faces()) {
      auto at = mesh.cfv_iter(face);
      const Mesh::Point p = mesh.point(*at++), q = mesh.point(*at++), r = mesh.point(*at);
      const double its = 0.5 * ((q - p) % (r - p))[2];
      area += its;
      covered += its < 0 ? -its : its;
    }
    std::printf("%d triangles: area %g, of all triangles %g, corners %d\n",
                static_cast<int>(mesh.n_faces()), area, covered, corners);
  }
}
END
library=$(dirname "$(find "$folder/root" -name 'libOpenMeshCore.so' | head -n 1)")
if ! c++ -std=c++17 -w "$folder/outline.cpp" -I"$folder/root/usr/include" -L"$library" \
  -lOpenMeshCore -lOpenMeshTools -Wl,-rpath,"$library" -o "$folder/outline" 2>"$folder/said"; then
  cat "$folder/said"
  echo "it does not compile here"
  exit 77
fi
"$folder/outline" | tee "$folder/printed"
# A square that stays one has the area 64, twice, and 4 corners.
grep -q '^64 triangles: area 56, of all triangles 59, corners 2$' "$folder/printed" &&
  grep -q '^32 triangles: area 32, .*corners 1$' "$folder/printed"
