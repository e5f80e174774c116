#!/usr/bin/env bash
# Tries the project on another Debian, on this machine: on a bare system in a folder, entered so
# that all layers of the sandbox work there as on a machine of its own.
#
#   try_on.sh SUITE                       the README's two commands as root, and `check` as an
#                                         ordinary user; a line for each step
#   try_on.sh SUITE --uncommitted         with what is not committed yet
#   try_on.sh SUITE --again               in the system as the last try left it, builds and all
#   try_on.sh SUITE COMMAND...            only this command, as root, in the project's folder
#   try_on.sh SUITE --archive FILE        the archive of `./meshgrade package`, in a bare system with
#                                         a compiler: unpacked and used by an ordinary user
#
# SUITE is a name such as trixie or forky. Takes root, a Debian or Ubuntu, and some 5 GB below
# $MESHGRADE_SYSTEMS (build/systems if not set); packages come from this machine's own mirror.
# Exit codes: 0 if every step ended well, 1 if one failed, 2 for what the caller can mend, and
# 4 if the mirror does not have the suite or cannot be reached.
set -euo pipefail

say() { printf '%s: %s\n' "${suite:-try_on}" "$*"; }
stop() { say "$2" && exit "$1"; }

project=$(cd -- "$(dirname "$0")/../.." && pwd)
suite=${1-}
case $suite in
  '' | *[!a-z]*) stop 2 "which Debian? For example: tests/systems/try_on.sh trixie" ;;
esac
shift
commit=committed again='' archive=''
while :; do
  case ${1-} in
    --archive)
      archive=${2-}
      [ -f "$archive" ] || stop 2 "there is no archive \"$archive\""
      shift
      ;;
    --uncommitted) commit=uncommitted ;;
    --again) again=yes ;;
    -*) stop 2 "there is no option $1" ;;
    *) break ;;
  esac
  shift
done
[ "$(id -u)" = 0 ] || stop 2 "another system can be made by root only"
command -v apt-get >/dev/null || stop 2 "it takes a Debian or Ubuntu"

home=${MESHGRADE_SYSTEMS:-$project/build/systems}/$suite
bare=$home/bare      # as it was made; never entered after that
system=$home/system  # a copy, in which things are tried
place=/opt/meshgrade # where the project lies in there
mkdir -p "$home/logs"
exec 9>"$home/lock"
flock -n 9 || stop 2 "somebody else tries it there at the moment"

# step NAME COMMAND...: a line that tells how it went; the output goes to a log of that name.
step() {
  local name=$1 log began=$SECONDS code=0
  log=$home/logs/${name//[^a-z]/_}.log
  shift
  "$@" >"$log" 2>&1 </dev/null || code=$?
  if [ "$code" = 0 ]; then
    say "$name: ok, $((SECONDS - began)) s"
    return
  fi
  say "$name: FAILED with exit code $code, $((SECONDS - began)) s; the log is $log"
  tail -n 30 "$log" | sed 's/^/  | /'
  return 1
}

# --- The system ---------------------------------------------------------------------------

# The mirror is the one that apt uses here.
mirror() {
  # shellcheck disable=SC2016  # apt expands it
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' |
    sed -n -e '/security/d' -e 's,/*$,,p' | head -n 1
}

suite_is_reachable() {
  /usr/lib/apt/apt-helper -o Acquire::Retries=1 download-file \
    "$(mirror)/dists/$suite/InRelease" "$home/InRelease" >"$home/logs/reachable.log" 2>&1
}

make_bare() {
  command -v debootstrap >/dev/null || {
    apt-get update && apt-get install -y --no-install-recommends debootstrap
  }
  local script=/usr/share/debootstrap/scripts/$suite
  [ -e "$script" ] || script=/usr/share/debootstrap/scripts/sid
  rm -rf "$bare" "$bare.new"
  debootstrap --variant=minbase "$suite" "$bare.new" "$(mirror)" "$script"
  # Services of packages are not started in there.
  printf '#!/bin/sh\nexit 101\n' >"$bare.new/usr/sbin/policy-rc.d"
  chmod +x "$bare.new/usr/sbin/policy-rc.d"
  chroot "$bare.new" useradd --create-home --shell /bin/bash student
  mkdir "$bare.new/old_root"
  mv "$bare.new" "$bare"
}

# How this machine reaches the network, which may change after the system was made.
take_network_settings() {
  apt-config dump | grep -E '^Acquire::(Check-|http|https|ftp)' >"$system/etc/apt/apt.conf.d/90machine" || true
  cp -L /etc/hosts /etc/resolv.conf "$system/etc/"
  mkdir -p "$system/etc/ssl"
  cp -L /etc/ssl/certs/ca-certificates.crt "$system/etc/ssl/machine.crt" 2>/dev/null || true
}

take_system() {
  if [ -n "$again" ] && [ -d "$system" ]; then return; fi
  rm -rf "$system"
  cp -a --reflink=auto "$bare" "$system"
}

# inside USER COMMAND...: a chroot alone may not make user namespaces, which the sandbox needs.
# So the folder becomes the root of a mount namespace. What is started in there ends with it.
inside() {
  local user=$1 folder=$place
  shift
  [ "$user" = root ] || folder=/home/$user
  # shellcheck disable=SC2016  # the inner shells expand these
  unshare --mount --pid --fork --kill-child --propagation private bash -c '
    set -e
    system=$1 && shift
    mount --bind "$system" "$system"
    cd "$system"
    mount -t proc proc proc
    mount --rbind /dev dev
    mount --rbind /sys sys
    pivot_root . old_root
    exec chroot . /bin/bash -c "umount -l /old_root && cd \"\$0\" && \"\$@\"" "$@"' \
    enter "$system" "$folder" \
    /usr/bin/setpriv --reuid="$user" --regid="$user" --init-groups \
    /usr/bin/env -i "${environment[@]}" HOME="$([ "$user" = root ] && echo /root || echo "$folder")" "$@"
}

environment=(PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8)
if [ -e /etc/ssl/certs/ca-certificates.crt ]; then
  environment+=(NODE_EXTRA_CA_CERTS=/etc/ssl/machine.crt npm_config_cafile=/etc/ssl/machine.crt)
fi
if command -v npm >/dev/null; then
  environment+=("npm_config_registry=$(npm config get registry)")
fi

# --- The project --------------------------------------------------------------------------

# What is not committed becomes a commit that no branch has, made with an index of its own.
commit_to_try() {
  local index=$home/index tree
  if [ "$commit" = committed ]; then
    git -C "$project" rev-parse HEAD
    return
  fi
  rm -f "$index"
  GIT_INDEX_FILE=$index git -C "$project" read-tree HEAD
  GIT_INDEX_FILE=$index git -C "$project" add --all
  tree=$(GIT_INDEX_FILE=$index git -C "$project" write-tree)
  git -C "$project" -c user.name=try_on -c user.email=try_on@localhost \
    commit-tree -p HEAD -m "What is tried" "$tree"
}

# Files that stay the same keep their time, so that a try on top of another builds little.
take_project() {
  local clone=$system$place tried
  tried=$(commit_to_try)
  [ -d "$clone" ] || git init --quiet "$clone"
  git -C "$project" push --quiet --force "$clone" "$tried:refs/heads/tried"
  git -C "$clone" checkout --quiet --force --detach "$tried"
}

# ------------------------------------------------------------------------------------------

if ! [ -d "$bare" ]; then
  suite_is_reachable ||
    stop 4 "not tried: this machine's package mirror does not have it, or cannot be reached"
  step "a bare system" make_bare || exit 1
fi
# The archive is tried in a system of its own: that in which the sources are built has more.
[ -z "$archive" ] || system=$home/system_with_compiler
step "its copy" take_system || exit 1
take_network_settings
if [ -n "$archive" ]; then
  place=/
  cp "$archive" "$system/home/student/program.tar.gz"
  step "a compiler" inside root bash -c "apt-get update &&
    DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends g++" || exit 1
  step "unpacking, as an ordinary user" inside student bash -c \
    "rm -rf program homework .cache && mkdir program &&
     tar -xzf program.tar.gz -C program --strip-components=1" || exit 1
  step "the first verdict" inside student bash -c \
    "cp -r program/share/meshgrade/reference homework && program/bin/meshgrade check homework" ||
    exit 1
  step "the next one" inside student program/bin/meshgrade check homework || exit 1
  # shellcheck disable=SC2016  # the inner shell expands these
  step "a handout with it, as root" inside root bash -c '
    rm -rf /opt/handout && cd /opt && /home/student/program/bin/meshgrade handout -o handout &&
    handout/meshgrade doctor && handout/meshgrade check handout/student_skeleton >said
    cat said && grep -q "0 / 100" said && ! [ -e handout/build ]' || exit 1
  step "the set-up of a Gradescope autograder" inside root bash -c '
    rm -rf /autograder && mkdir -p /autograder/source /autograder/submission /autograder/results &&
    cd /autograder && /home/student/program/bin/meshgrade bundle gradescope -o /tmp/bundle.tar &&
    tar -xf /tmp/bundle.tar -C source && mv source/run_autograder . && bash source/setup.sh' || exit 1
  step "what it says of a submission" inside root bash -c '
    cd /autograder && cp -r /home/student/homework/. submission && ./run_autograder &&
    cat results/results.json && grep -q "\"output_format\"" results/results.json'
  exit
fi
step "the project's sources" take_project || exit 1

if [ $# -gt 0 ]; then
  step "$*" inside root "$@"
  exit
fi
failed=
step "check reference, as root" inside root ./meshgrade check reference || failed=yes
step "check, as an ordinary user" inside student bash -c \
  "cp -r $place/reference homework && $place/meshgrade check homework" || failed=yes
step "self-test, as root" inside root ./meshgrade self-test || failed=yes
[ -z "$failed" ] || exit 1
