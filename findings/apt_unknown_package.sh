#!/usr/bin/env bash
# believed: apt-get install installs the packages that it knows, and names the others.
# happens: one name that the suite does not have, and none of the others is installed.
# seen with: apt 2.6 (Debian 12), apt 3.0 (Debian 13)
# here: ./meshgrade asks apt first which of the packages it can install
set -uo pipefail
if ! command -v apt-get >/dev/null; then
  echo "there is no apt"
  exit 77
fi
if apt-get install --simulate bash meshgrade-has-no-such-package >/dev/null 2>&1; then
  echo "apt-get install takes a list with an unknown package"
  exit 1
fi
apt-get install --simulate bash >/dev/null 2>&1
