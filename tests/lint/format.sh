#!/usr/bin/env bash
# Checks that our sources are formatted as .clang-format says. Submissions under test are as
# their authors left them.
set -euo pipefail
cd -- "$(dirname "$0")/../.."

find . \( -path ./build -o -path ./tests/submissions \) -prune -o \
  \( -name '*.h' -o -name '*.cpp' \) -print0 | xargs -0 clang-format --dry-run -Werror
