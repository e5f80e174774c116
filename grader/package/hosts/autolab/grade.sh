#!/usr/bin/env bash
# grade.sh <a Meshgrade that is built already, if there is one>
#
# What was handed in lies beside the Makefile: one source file, several, or one archive.
set -uo pipefail
grader=$(dirname -- "$0")
home=$1
[ -x "$home/meshgrade" ] || home=$grader/meshgrade
mkdir -p handed_in
find . -maxdepth 1 -type f ! -name Makefile ! -name autograde-Makefile ! -name autograde.tar \
  -exec mv -- {} handed_in/ \;
files=(handed_in/*)
submission=handed_in
if [ ${#files[@]} = 1 ] && [ -f "${files[0]}" ]; then submission=${files[0]}; fi
exec bash "$home/meshgrade" autograde "$submission" --assignment "$grader/assignment.toml" \
  --write autolab=-
