#!/usr/bin/env bash
# Runs the findings whose names have $1 in them, or all, and prints what has changed.
set -uo pipefail
cd -- "$(dirname "$0")" || exit
same=0 changed=0 elsewhere=0
for script in *"${1-}"*.sh; do
  if [ "$script" = run_all.sh ] || ! [ -f "$script" ]; then continue; fi
  said=$(bash "$script" 2>&1 </dev/null)
  case $? in
    0) same=$((same + 1)) ;;
    1)
      changed=$((changed + 1))
      echo "CHANGED: ${script%.sh} is no longer so:"
      sed -n 's/^# happens: /  it was: /p' "$script"
      printf '%s\n' "$said" | tail -n 5 | sed 's/^/  now: /'
      ;;
    77)
      elsewhere=$((elsewhere + 1))
      echo "not here: ${script%.sh}: $(printf '%s\n' "$said" | tail -n 1)"
      ;;
    *)
      changed=$((changed + 1))
      echo "BROKEN: ${script%.sh} did not come to its end:"
      printf '%s\n' "$said" | tail -n 5 | sed 's/^/  /'
      ;;
  esac
done
echo "$same as before, $changed changed, $elsewhere cannot be shown here"
[ "$changed" = 0 ]
