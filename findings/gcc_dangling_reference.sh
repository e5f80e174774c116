#!/usr/bin/env bash
# believed: -Wdangling-reference, part of -Wall since GCC 13, means that a reference dangles.
# happens: GCC 14 warns of every function that takes a const std::string&, is given a literal, and returns a reference, though what it returns lives for ever.
# seen with: GCC 14.2, Debian 13; GCC 12 does not have the warning
# here: tests/subdivide/course_meshes.h takes const char*; warnings are errors in CI only
set -uo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
compiler=${CXX:-g++}
if ! "$compiler" --version 2>/dev/null | grep -qi 'gcc\|g++\|Free Software'; then
  echo "there is no GCC"
  exit 77
fi
if ! "$compiler" -Werror -Wdangling-reference -x c++ -fsyntax-only /dev/null 2>/dev/null; then
  echo "GCC $("$compiler" -dumpversion) does not have this warning"
  exit 77
fi
cat >"$folder/lives.cpp" <<'END'
#include <string>
static int number = 7;
const int& by_name(const std::string& name) { return name.empty() ? number : number; }
int main() {
  const int& seven = by_name("seven");
  return seven - 7;
}
END
"$compiler" -Wall -c "$folder/lives.cpp" -o "$folder/lives.o" 2>&1 | tee "$folder/said"
grep -q dangling-reference "$folder/said"
