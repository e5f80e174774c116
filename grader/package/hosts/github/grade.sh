#!/usr/bin/env bash
# Grades the repository that this folder lies in, for a step of GitHub Actions. Nothing that
# the students' code prints reaches the step's own output: see `meshgrade autograde --help`.
set -uo pipefail
here=$(cd -- "$(dirname -- "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
bash "$here/meshgrade" autograde "$here/.." \
  --write "github-annotations=-" \
  --write "markdown=$folder/summary.md" \
  --write "github-result=$folder/result.txt"
status=$?
[ -f "$folder/summary.md" ] || exit "$status"  # nothing was graded
[ -z "${GITHUB_STEP_SUMMARY-}" ] || cat "$folder/summary.md" >>"$GITHUB_STEP_SUMMARY"
[ -z "${GITHUB_OUTPUT-}" ] || printf 'result=%s\n' "$(cat "$folder/result.txt")" >>"$GITHUB_OUTPUT"
exit "$status"
