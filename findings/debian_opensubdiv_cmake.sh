#!/usr/bin/env bash
# believed: find_package(OpenSubdiv CONFIG) works where libosd-dev is installed.
# happens: it stops with an error, for the package's targets name a static library that is not shipped.
# seen with: libosd-dev 3.5.0, Debian 12, and 3.6.0, Debian 13
# here: cmake/FindOpenSubdivCpu.cmake looks for the headers and the shared library itself
set -uo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if ! [ -e /usr/include/opensubdiv/version.h ] || ! command -v cmake >/dev/null || ! command -v ninja >/dev/null; then
  echo "libosd-dev, cmake or ninja is not installed"
  exit 77
fi
cat >"$folder/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.22)
project(finding LANGUAGES CXX)
find_package(OpenSubdiv REQUIRED CONFIG)
END
if cmake -G Ninja -S "$folder" -B "$folder/build" >"$folder/said" 2>&1; then
  echo "find_package(OpenSubdiv REQUIRED CONFIG) works"
  exit 1
fi
cat "$folder/said"
if ! grep -q 'libosdCPU.a\|does not exist' "$folder/said"; then
  echo "cmake fails for another reason"
  exit 77
fi
