#!/usr/bin/env bash
# tests/memory_sweep.sh FROM TO STEP SCRIPT [word...]: runs a script within so many MB of address space each. It fails
# where grsh ends by a signal or without a word. GRSH names another grsh than the checkout's.
set -uo pipefail
here=$(readlink -f "$0")
grsh=$(readlink -f "${GRSH:-${here%/tests/*}/grsh}")
(($# >= 4)) || { echo "usage: tests/memory_sweep.sh FROM TO STEP SCRIPT [word...]" >&2; exit 2; }
from=$1 to=$2 step=$3
shift 3
failed=0
out=$(mktemp)
trap 'rm -f "$out"' EXIT
for ((megabytes = from; megabytes <= to; megabytes += step)); do
    code=0
    (ulimit -c 0; ulimit -v $((megabytes * 1024)); exec "$grsh" "$@") >"$out" 2>&1 || code=$?
    last=$(tail -n 1 "$out")
    if ((code > 1)) || [[ $code == 1 && ! $last =~ :\  ]]; then
        echo "FAILED $megabytes MB: exit code $code: $last"
        failed=1
    else
        echo "$megabytes MB: exit code $code: $last"
    fi
done
exit $failed
