#!/usr/bin/env bash
# believed: root may make user namespaces in a chroot as everywhere else.
# happens: the kernel refuses (EPERM) in a plain chroot, and allows it once the same folder has become the root by pivot_root; so a sandbox seems to be missing in a chroot.
# seen with: Linux 6, util-linux 2.38
# here: tests/systems/try_on.sh enters other systems by pivot_root
set -uo pipefail
if [ "$(id -u)" != 0 ] || ! unshare --mount --user true 2>/dev/null; then
  echo "it takes root, and user namespaces"
  exit 77
fi
folder=$(mktemp -d)
trap 'rmdir "$folder"' EXIT
# shellcheck disable=SC2016  # the inner shell expands it
unshare --mount --propagation private bash -c '
  mount --rbind / "$1" || exit 77
  chroot "$1" unshare --user true 2>/dev/null && in_chroot=works
  cd "$1" && pivot_root . "./${1#/}" && chroot . unshare --user true && by_pivot=works
  echo "in a chroot: ${in_chroot:-refused}; after pivot_root: ${by_pivot:-refused}"
  [ -z "${in_chroot-}" ] && [ -n "${by_pivot-}" ]' finding "$folder"
