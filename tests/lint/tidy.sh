#!/usr/bin/env bash
# Runs clang-tidy over every source of our own that a build folder compiles, but the tests: what
# is wrong with a test shows when it runs, and this is what takes longest of all checks.
#
#   tidy.sh <build folder>
#
# A source that passes leaves a stamp beside its object file. Ninja makes that object anew when
# the source or one of its headers changes, so a stamp younger than the object still holds.
set -euo pipefail
cd -- "$(dirname "$0")/../.."
build=$1
commands=$build/tidy

# Each source once, however often it is compiled, and without GCC's precompiled headers: a
# source has to include what it uses.
write_commands() {
  mkdir -p "$commands"
  # A path with a space in it stands in quotes, which JSON escapes.
  sed -E -e 's/ -Winvalid-pch -include (\\"[^"]*"|[^ ]+)//' "$build/compile_commands.json" |
    awk -v RS='}' -v build="\"file\": \"$build/" -v tests="\"file\": \"$PWD/tests/" '
      match($0, /"file": "[^"]*"/) {
        file = substr($0, RSTART, RLENGTH)
        if (seen[file]++ || index(file, build) == 1 || index(file, tests) == 1) next
        sub(/^[^{]*/, "")
        printf "%s%s}", (count++ ? "," : "["), $0
      }
      END { print "]" }' >"$commands/compile_commands.json"
}

if [ $# = 1 ]; then
  write_commands
  settings=$build/tidy-settings
  changed=$(find . -path ./build -prune -o -name .clang-tidy -newer "$settings" -print 2>&1 || true)
  if [ -n "$changed" ]; then
    find "$build" -name '*.o.tidy' -delete
    touch "$settings"
  fi
  # Of each entry its object, which is in the command, and its source.
  sed -n -e 's/^ *"command": .* -o \([^ ]*\) -c .*/\1/p' -e 's/^ *"file": "\(.*\)",*$/\1/p' \
    "$commands/compile_commands.json" |
    tr '\n' '\0' | xargs -0 -n 2 -P "$(getconf _NPROCESSORS_ONLN)" "$0" "$build"
  exit
fi

object=$build/$2
source=$3
if [ "$object.tidy" -nt "$object" ]; then exit; fi
# It tells on stderr how many warnings of other people's headers it has left out.
if found=$(clang-tidy -p "$commands" --quiet "$source" 2>&1); then
  touch "$object.tidy"
else
  printf '%s\n' "$found"
  exit 1
fi
