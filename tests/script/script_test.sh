#!/usr/bin/env bash
# Tests of the script ./meshgrade. It runs in a copy of the project that holds nothing else,
# with a PATH that holds nothing but stand-ins and a few plain tools: so nothing is installed
# and nothing is compiled.
#
#   script_test.sh <path of ./meshgrade> <name of a test>
set -euo pipefail

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
project="$scratch/a project"
calls=$scratch/calls
mkdir -p "$project" "$scratch/bin"
cp "$1" "$project/meshgrade"
echo '{}' >"$project/CMakePresets.json"
: >"$calls"

# stand_in <tool>: a script that notes its call and then does what stdin says.
stand_in() {
  { printf '#!/bin/bash\necho "%s $*" >>"%s"\n' "$1" "$calls"; cat; } >"$scratch/bin/$1"
  chmod +x "$scratch/bin/$1"
}

for tool in bash cat chmod cp env flock grep ln mkdir mv readlink rm sleep tail tr; do
  if path=$(command -v "$tool"); then ln -s "$path" "$scratch/bin/$tool"; fi
done
stand_in c++ </dev/null
stand_in apt-get </dev/null
stand_in sudo <<<'exit 1'
stand_in id <<<'echo 1000'
stand_in cmake <<'END'
: >build/release/build.ninja
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/release/CMakeCache.txt
END
stand_in dpkg-query <<'END'
case " $MISSING " in *" ${@: -1} "*) exit 1 ;; esac
printf installed
END
stand_in ninja <<'END'
echo "[1/1] Linking"
mkdir -p "$2/bin"
cp "$PROGRAM" "$2/bin/meshgrade"
sleep 0.2
echo "ninja ends" >>"$CALLS"
END
cat >"$scratch/program" <<'END'
#!/bin/bash
printf '<%s>' "$@"
END
chmod +x "$scratch/program"

export MISSING=none CALLS="$calls" PROGRAM="$scratch/program"
unset CXX
PATH=$scratch/bin

fail() {
  printf 'FAILED: %s\n--- stdout\n%s\n--- stderr\n%s\n--- calls\n%s\n' \
    "$1" "$out" "$(cat "$scratch/err")" "$(cat "$calls")"
  exit 1
}

# call <command...>: leaves its stdout in $out and its exit code in $code.
call() {
  code=0
  out=$("$@" 2>"$scratch/err" </dev/null) || code=$?
}
err_has() { case $(cat "$scratch/err") in *"$1"*) ;; *) fail "stderr lacks: $1" ;; esac; }
was_called() { case $(cat "$calls") in *"$1"*) return 0 ;; *) return 1 ;; esac; }

missing_package_without_root_is_named() {
  MISSING=libosd-dev
  call "$project/meshgrade" check
  [ "$code" = 2 ] || fail "exit code $code, not 2"
  [ -z "$out" ] || fail "stdout is not empty"
  err_has 'sudo apt-get install --no-install-recommends libosd-dev'
  ! was_called 'apt-get install -y' || fail "something was installed"
  ! was_called 'cmake' || fail "it went on to build"
}

missing_package_is_installed_by_root() {
  MISSING=libosd-dev
  stand_in id <<<'echo 0'
  call "$project/meshgrade" check
  was_called 'install -y --no-install-recommends libosd-dev
' || fail "apt-get was not asked for the missing package alone"
  [ "$out" = '<check>' ] || fail "the program did not run"
}

# This Debian knows all packages but slurm-wlm.
without_slurm() {
  MISSING='libgtest-dev slurm-wlm'
  stand_in apt-cache <<<'echo "500 http://mirror.example/debian"'
  stand_in apt-get <<<'case $* in *install*slurm-wlm*) exit 100 ;; esac'
  stand_in ctest </dev/null
}

package_that_the_system_lacks_keeps_no_other_back() {
  without_slurm
  stand_in id <<<'echo 0'
  call "$project/meshgrade" self-test -R EdgeFlip
  [ "$code" = 0 ] || fail "exit code $code"
  err_has 'there is no package slurm-wlm on this system'
  was_called 'install -y --no-install-recommends libgtest-dev
' || fail "the other package was not installed"
}

package_that_the_system_lacks_is_not_asked_for() {
  without_slurm
  call "$project/meshgrade" self-test -R EdgeFlip
  [ "$code" = 2 ] || fail "exit code $code, not 2"
  case $(cat "$scratch/err") in
    *'sudo apt-get install --no-install-recommends libgtest-dev') ;;
    *) fail "not just this package was asked for" ;;
  esac
  MISSING=slurm-wlm
  call "$project/meshgrade" self-test -R EdgeFlip
  [ "$code" = 0 ] || fail "exit code $code, though nothing can be installed"
}

arguments_reach_the_program_through_links() {
  ln -s "$project/meshgrade" "$scratch/link"
  ln -s link "$scratch/link to link"
  mkdir "$scratch/elsewhere"
  cd "$scratch/elsewhere"
  call "../link to link" check 'my homework' ''
  [ "$code" = 0 ] || fail "exit code $code"
  [ "$out" = '<check><my homework><>' ] || fail "other arguments"
  [ -x "$project/build/release/bin/meshgrade" ] || fail "built in another folder"
}

second_call_neither_configures_nor_asks_for_packages() {
  call "$project/meshgrade"
  was_called 'cmake --preset release' || fail "the first call did not configure"
  : >"$calls"
  call "$project/meshgrade"
  ! was_called 'cmake' || fail "configured again"
  ! was_called 'dpkg-query' || fail "asked for packages again"
  was_called 'ninja' || fail "did not look for changes"
}

moved_project_is_built_anew() {
  call "$project/meshgrade"
  mv "$project" "$scratch/new place"
  project="$scratch/new place"
  : >"$calls"
  call "$project/meshgrade" check
  was_called 'cmake --preset release' || fail "did not configure"
  [ "$out" = '<check>' ] || fail "the program did not run"
}

failed_build_shows_its_end_and_the_log() {
  stand_in ninja <<<'echo "[1/2] Building"; echo "edge.cpp:7: error: oh"; exit 1'
  call "$project/meshgrade" check
  [ "$code" = 3 ] || fail "exit code $code, not 3"
  [ -z "$out" ] || fail "stdout is not empty"
  err_has 'edge.cpp:7: error: oh'
  err_has "$project/build/release/build.log"
}

fuzz_of_an_unknown_target_is_said() {
  mkdir -p "$project/tests/fuzz/corpus/obj"
  call "$project/meshgrade" fuzz obk
  [ "$code" = 2 ] || fail "exit code $code, not 2"
  err_has 'there is no fuzz target "obk"; there are: obj'
  call "$project/meshgrade" fuzz obj -- soon
  [ "$code" = 2 ] || fail "exit code $code, not 2, for seconds that are no number"
}

fuzz_goes_on_after_a_find_and_fails() {
  mkdir -p "$project/tests/fuzz/corpus/obj" "$project/tests/fuzz/corpus/off"
  stand_in cmake </dev/null
  stand_in ninja <<'END'
mkdir -p "$2/tests/fuzz"
printf '#!/bin/bash\necho "ran off $*"\n' >"$2/tests/fuzz/fuzz_off"
printf '#!/bin/bash\nexit 77\n' >"$2/tests/fuzz/fuzz_obj"
chmod +x "$2/tests/fuzz/"*
END
  call "$project/meshgrade" fuzz -- 7
  [ "$code" = 1 ] || fail "exit code $code, not 1"
  err_has 'broken promises: obj;'
  case $out in *"ran off -max_total_time=7 "*) ;; *) fail "off did not run for 7 s" ;; esac
}

build_folder_that_cannot_be_written_is_said() {
  : >"$project/build"
  call "$project/meshgrade" check
  [ "$code" = 2 ] || fail "exit code $code, not 2"
  err_has "cannot write to $project/build/release"
}

# The calls of ninja must not overlap: each ends before the next begins.
two_calls_take_turns() {
  "$project/meshgrade" first >/dev/null 2>&1 &
  call "$project/meshgrade" second
  wait
  [ "$out" = '<second>' ] || fail "the second did not run"
  local line last=ends
  while read -r line; do
    case $line in
      'ninja ends') last=ends ;;
      'ninja '*) [ "$last" = ends ] || fail "two builds at once"; last=began ;;
    esac
  done <"$calls"
}

two_calls_take_turns_without_flock() {
  rm -f "$scratch/bin/flock"
  mkdir "$project/build"
  ln -s pid-999999999 "$project/build/lock-owner"
  two_calls_take_turns
  [ ! -L "$project/build/lock-owner" ] || fail "the lock was left behind"
}

"$2"
