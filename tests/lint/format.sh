#!/usr/bin/env bash
# Checks that our sources are formatted as .clang-format says. Submissions under test are as
# their authors left them. Other versions of clang-format break lines elsewhere: 77, "skipped".
set -euo pipefail
cd -- "$(dirname "$0")/../.."

version=$(clang-format --version)
case $version in
  *' version 14.'*) ;;
  *) echo "skipped: the format is that of clang-format 14, and this is $version" && exit 77 ;;
esac

report=$(find . \( -path ./build -o -path ./tests/submissions \) -prune -o \
  \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 -P 2 -n 25 clang-format --dry-run -Werror 2>&1) && exit
files=$(printf '%s\n' "$report" | sed -n 's/^\(.*\):[0-9]*:[0-9]*: error: code should.*/\1/p')
echo "clang-format -i would change these:"
printf '%s\n' "${files:-$report}" | uniq
exit 1
