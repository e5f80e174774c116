#!/usr/bin/env bash
# viewer_test.sh <test> <source> <workshop> <program>: one test of the viewer's page. The
# packages of the lock file are installed in the workshop, a folder of the build.
set -euo pipefail

test=$1 source=$2 workshop=$3 program=$4

# A copy of the sources beside the packages; what was deleted there is deleted here.
copy_sources() {
  mkdir -p "$workshop"
  rm -rf "$workshop/src" "$workshop/test"
  cp -R "$source/viewer/src" "$source/viewer/test" "$workshop"
  cp "$source"/viewer/{package.json,package-lock.json,.npmrc,tsconfig.json,build.mjs} "$workshop"
}

install_packages() {
  local stamp=$workshop/installed
  if cmp -s "$source/viewer/package-lock.json" "$stamp"; then return; fi
  rm -f "$stamp"
  (cd "$workshop" && npm ci --no-progress)
  cp "$source/viewer/package-lock.json" "$stamp"
}

case $test in
  packages)
    copy_sources
    install_packages
    ;;
  types) cd "$workshop" && node_modules/.bin/tsc --noEmit ;;
  bundle_is_that_of_the_sources)
    (cd "$workshop" && node build.mjs "$workshop/viewer.html")
    cmp "$workshop/viewer.html" "$source/viewer/dist/viewer.html" || {
      echo "viewer/dist/viewer.html is not what its sources give; build it again:" >&2
      echo "  cd viewer && npm ci && npm run build" >&2
      exit 1
    }
    ;;
  logic) cd "$workshop" && node --test test/unit/ ;;
  browser)
    cd "$workshop"
    MESHGRADE_PROGRAM=$program MESHGRADE_SOURCE=$source \
      node --test --test-concurrency=1 --test-reporter=spec test/browser/*.test.mjs
    ;;
  *)
    echo "there is no test $test" >&2
    exit 2
    ;;
esac
