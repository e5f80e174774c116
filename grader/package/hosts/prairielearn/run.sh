#!/usr/bin/env bash
# The entry point of the question's external grader: "entrypoint": "/grade/tests/run.sh".
# The students' files are in ../student, and the result goes to ../results.
set -uo pipefail
grade=$(cd -- "$(dirname -- "$0")/.." && pwd)
home=${MESHGRADE_HOME:-/opt/meshgrade}
mkdir -p "$grade/results"
chmod 700 "$grade/results" "$grade/tests"
bash "$home/meshgrade" autograde "$grade/student" --write "prairielearn=$grade/results/results.json"
