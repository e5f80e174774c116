#!/usr/bin/env bash
# believed: two versions of a C library with one SONAME can be exchanged: a call that compiles against the one compiles against the other.
# happens: meshopt_encodeFilterExp has one argument more in 0.22 than in 0.18, a required one in C and in C++, and both are libmeshoptimizer.so.2d. A program that was built with 0.18 starts with 0.22, and hands over an argument that was never set.
# seen with: meshoptimizer 0.18 (Debian 12) and 0.22 (Debian 13). In 0.18 the function is marked as experimental
# here: tests/files/gltf_file_test.cpp asks for MESHOPTIMIZER_VERSION; the program itself calls decoders only, which are the same in both
set -uo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for tool in apt-get dpkg-deb cc objdump; do
  if ! command -v "$tool" >/dev/null; then
    echo "there is no $tool"
    exit 77
  fi
done
# shellcheck disable=SC2016  # apt expands it
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' |
  sed -n -e '/security/d' -e 's,/*$,,p' | head -n 1)
for version in 0.18+dfsg-2 0.22+dfsg-1; do
  for package in libmeshoptimizer2d libmeshoptimizer-dev; do
    file=${package}_${version}_amd64.deb
    if ! /usr/lib/apt/apt-helper download-file "$mirror/pool/main/m/meshoptimizer/$file" \
      "$folder/$file" >/dev/null 2>&1; then
      echo "the package mirror does not have $file"
      exit 77
    fi
    dpkg-deb -x "$folder/$file" "$folder/$version"
  done
  objdump -p "$folder/$version"/usr/lib/*/libmeshoptimizer.so.2d | grep SONAME |
    sed "s/^/$version: /" | tee -a "$folder/sonames"
done
cat >"$folder/five.c" <<'END'
#include <stddef.h>
#include <meshoptimizer.h>
void encode(void* out, const float* data) { meshopt_encodeFilterExp(out, 4, 12, 15, data); }
END
compiles() { cc -c "$folder/five.c" -I"$folder/$1/usr/include" -o "$folder/five.o" >"$folder/said" 2>&1; }
compiles 0.18+dfsg-2 || { cat "$folder/said" && exit 1; }
if compiles 0.22+dfsg-1; then exit 1; fi
grep 'too few arguments' "$folder/said" || exit 1
[ "$(grep -c 'libmeshoptimizer.so.2d' "$folder/sonames")" = 2 ]
