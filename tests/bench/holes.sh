#!/usr/bin/env bash
# tests/bench/holes.sh [ROUNDS]: how long grsh and POV-Ray take for a box with 100 holes, in processor seconds, in turns,
# and the median ratio. Both use one thread for 320 x 240 pixels of 17 samples, 4 shadow rays each: with a threshold of
# 0 POV-Ray's method 1 takes one sample of each pixel and 4 x 4 more. Starting, reading and writing count in both.
set -euo pipefail
here=$(readlink -f "$0")
# shellcheck source=tools/lib/setup.sh
source "${here%/tests/*}/tools/lib/setup.sh"
# shellcheck disable=SC2154 # set there
bench=$root/tests/bench
rounds=${1:-3}
command -v povray >/dev/null || need povray
export LC_ALL=C

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# User and system seconds of a command.
seconds() {
    local TIMEFORMAT='%U %S' spent
    spent=$({ time "$@" >log 2>&1; } 2>&1) || { cat log >&2 && exit 1; }
    awk '{ print $1 + $2 }' <<<"$spent"
}

for ((round = 0; round < rounds; round++)); do
    ours=$(seconds "$root/grsh" "$bench/holes.gr")
    theirs=$(seconds povray "+I$bench/holes.pov" +Oholes-povray.png +W320 +H240 +WT1 +A0.0 +AM1 +R4 -J -D -V -GA)
    echo "grsh $ours s, POV-Ray $theirs s"
    awk "BEGIN { print $theirs / $ours }" >>ratios
done
sort -g ratios | awk '{ ratio[NR] = $1 }
    END { printf "POV-Ray / grsh: %.2f (%.2f to %.2f)\n", ratio[int((NR + 1) / 2)], ratio[1], ratio[NR] }'
