#!/usr/bin/env bash
# program_test.sh BUILD SOURCE: the program as `./meshgrade package` packs it, put into a folder
# that it was not built in, and used by somebody who has a C++ compiler and nothing else of ours.
set -euo pipefail

build=$1 source=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

failed=0
# expect WHAT TEXT PART: the text holds the part.
expect() {
  case $2 in *"$3"*) return ;; esac
  printf 'FAILED: %s: expected "%s" in:\n%s\n' "$1" "$3" "$2"
  failed=1
}
expect_no() {
  case $2 in *"$3"*) ;; *) return ;; esac
  printf 'FAILED: %s: expected no "%s" in:\n%s\n' "$1" "$3" "$2"
  failed=1
}

cmake --install "$build" --prefix "$place/built" --strip >"$place/install.log"
mv "$place/built" "$place/a folder"
prefix="$place/a folder"
program="$prefix/bin/meshgrade"
# Others have to get there: who grades as root lets another user compile.
chmod 755 "$place"

# run ARGUMENTS...: with nothing in the environment but a PATH and a cache of its own.
run() {
  env -i PATH=/usr/local/bin:/usr/bin:/bin HOME="$place/home" XDG_CACHE_HOME="$place/cache" \
    "$program" "$@" 2>&1 || true
}

cp -r "$source/reference" "$place/homework"
said=$(run check "$place/homework")
expect "the first call" "$said" "compiling the shared headers, once"
expect "the first call" "$said" "100 / 100"
said=$(run check "$place/homework")
expect_no "the second call" "$said" "compiling the shared headers"
expect "the second call" "$said" "100 / 100"

: >"$(echo "$place"/cache/meshgrade/kit-*/precompiled.h.gch)"
said=$(run check "$place/homework")
expect "a cache that was cut off" "$said" "compiling the shared headers, once"
expect "a cache that was cut off" "$said" "100 / 100"

chmod o+w "$place/cache/meshgrade"
said=$(run check "$place/homework" bezier_curve)
expect "a cache that others can write to" "$said" "cannot be kept for the next call"
expect "a cache that others can write to" "$said" "10 / 10"

mkdir "$place/no compiler"
for tool in sh objcopy; do ln -s "$(command -v "$tool")" "$place/no compiler/$tool"; done
said=$(env -i PATH="$place/no compiler" HOME="$place/home" "$program" check "$place/homework" \
  2>&1) && code=0 || code=$?
expect "no compiler" "$said" "sudo apt-get install g++"
expect "no compiler" "exit code $code" "exit code 2"

if command -v clang++ >/dev/null; then
  said=$(env -i PATH=/usr/local/bin:/usr/bin:/bin CXX=clang++ XDG_CACHE_HOME="$place/clang" \
    "$program" check "$place/homework" 2>&1 || true)
  expect "clang++" "$said" "100 / 100"
else
  echo "not tried with clang++: it is not installed here"
fi

# A handout that it writes brings it along, and builds nothing.
said=$(run handout -o "$place/handout")
expect "a handout" "$said" "the students' package"
said=$(env -i PATH=/usr/local/bin:/usr/bin:/bin XDG_CACHE_HOME="$place/cache2" \
  "$place/handout/meshgrade" check "$place/handout/student_skeleton" 2>&1 || true)
expect "the handout's program" "$said" "bezier_curve        not implemented"
expect "the handout's program" "$said" "0 / 100"
for made in build reference program/share/meshgrade/reference; do
  if [ -e "$place/handout/$made" ]; then
    echo "FAILED: the handout holds $made"
    failed=1
  fi
done

bash -n "$prefix/share/bash-completion/completions/meshgrade" || failed=1
expect "completions" "$(cat "$prefix/share/bash-completion/completions/meshgrade")" \
  "check) words='-h --help"
expect "completions" "$(cat "$prefix/share/fish/vendor_completions.d/meshgrade.fish")" \
  "__fish_seen_subcommand_from batch"
expect "completions" "$(cat "$prefix/share/zsh/vendor-completions/_meshgrade")" "#compdef meshgrade"
expect "the manual page" "$(cat "$prefix/share/man/man1/meshgrade.1")" ".SS meshgrade replay"

for library in "$prefix"/lib/meshgrade/*.so*; do
  case $(basename "$library") in libc.so* | libstdc++* | ld-linux*)
    echo "FAILED: $library belongs to the system"
    failed=1
    ;;
  esac
done
expect "licences" "$(ls "$prefix/share/meshgrade/licences")" "libosd"
exit "$failed"
