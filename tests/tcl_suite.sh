#!/usr/bin/env bash
# tests/tcl_suite.sh FOLDER [FILE...]: runs Tcl's own tests, those of FOLDER/tests, with tclsh8.6 and with grsh, test by
# test. It fails where they differ and tests/tcl_suite_differences.txt does not say why. FOLDER is the source of the Tcl
# that grsh is linked with, e.g. of "apt-get source tcl8.6". GRSH names another grsh than the checkout's.
set -euo pipefail
here=$(readlink -f "$0")
here=${here%/*}
(($#)) || { echo "usage: tests/tcl_suite.sh FOLDER [FILE...]" >&2; exit 2; }
suite=$(readlink -f "$1")/tests
shift
grsh=$(readlink -f "${GRSH:-${here%/*}/grsh}")
[[ -e $suite/all.tcl ]] || { echo "no Tcl tests in $suite" >&2; exit 2; }
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT

skipped=$(sed -n 's/^skip //p' "$here/tcl_suite_differences.txt" | tr '\n' ' ')

# Test names with what became of them, one a line. A file that does not come to its end is a result, too.
run_file() {
    local program=$1 file=$2 folder=$3 code=0
    mkdir -p "$folder/tmp" "$folder/home"
    (cd "$folder/home" && HOME=$PWD timeout 600 "$program" "$suite/$file" -verbose ps -tmpdir "$folder/tmp" -skip "$skipped" \
        </dev/null >"$folder/out" 2>&1) || code=$?
    grep -aoE '^(\+\+\+\+ \S+ (PASSED|SKIPPED)|==== \S+ .*FAILED$)' "$folder/out" |
        sed -E 's/^(\+\+\+\+|====) (\S+) .*(FAILED)$/\2 \3/; s/^\+\+\+\+ //' || true
    ((code < 2)) || echo "$file ENDED $code"
}

# What run_file has printed.
of_file() { cat "$work/$1/$2/results"; }

results() {
    local program=$1 name=$2 file
    shift 2
    for file; do
        mkdir -p "$work/$name/$file"
        run_file "$program" "$file" "$work/$name/$file" >"$work/$name/$file/results"
    done
    cat "$work/$name"/*/results | sort -u >"$work/$name.txt"
}

cd "$suite"
files=("$@")
((${#files[@]})) || files=(*.test)
cd "$work"
# One after the other: some of the tests open ports of fixed numbers, and measure times.
results "$(command -v tclsh8.6)" tclsh "${files[@]}"
results "$grsh" grsh "${files[@]}"

if [[ -n ${KEEP:-} ]]; then cp -r "$work"/*.txt "$work"/tclsh "$work"/grsh "$KEEP"; fi

sed -E '/^#|^$/d; s/^skip //' "$here/tcl_suite_differences.txt" >known.txt
differences() {
    diff "$1.txt" "$2.txt" | sed -nE 's/^</tclsh8.6:/p; s/^>/grsh:    /p' |
        awk 'FILENAME == "known.txt" {known[$1]; next} !($2 in known)' known.txt - | sort -k2 || true
}
echo "$(wc -l <tclsh.txt) results of tclsh8.6, $(wc -l <grsh.txt) of grsh, $(wc -l <known.txt) known to differ"
[[ -s tclsh.txt ]] || { echo "tclsh8.6 has run none of them"; exit 1; }
differences tclsh grsh >different.txt
[[ -s different.txt ]] || exit 0

# Some tests depend on how busy the machine is: what differs must do so twice.
mapfile -t files < <(for file in "${files[@]}"; do
    diff -q <(of_file tclsh "$file") <(of_file grsh "$file") >/dev/null || echo "$file"
done)
results "$(command -v tclsh8.6)" tclsh2 "${files[@]}"
results "$grsh" grsh2 "${files[@]}"
differences tclsh2 grsh2 >again.txt
sort different.txt again.txt | uniq -d >twice.txt
if [[ -s twice.txt ]]; then sort -k2 twice.txt; exit 1; fi
