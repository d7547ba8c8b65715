#!/usr/bin/env bash
# wider_symbols.sh OBJECT... : what is compiled for wider processors offers the linker one function each, that of its
# own name, path_NAME.o grsh_path_integrator_NAME: of anything else an older processor might be given this copy.
# wider_symbols.sh --self-test OBJECT: such an object as the compiler leaves it, which offers more, is told of.
set -euo pipefail

offered() { nm --defined-only --extern-only --format=posix "$1" | cut -d ' ' -f 1; }

# Prints what is wrong.
check() {
    local name=${1##*/path_}
    local own=grsh_path_integrator_${name%.o} symbols
    symbols=$(offered "$1")
    [[ $symbols == "$own" ]] || printf '%s offers more or less than %s:\n%s\n' "$1" "$own" "$symbols"
}

if [[ ${1-} == --self-test ]]; then
    copy=$(mktemp -d)
    trap 'rm -r "$copy"' EXIT
    cp "$2" "$copy/path_baseline.o"
    [[ $(check "$copy/path_baseline.o") == *_ZN* ]] && exit 0
    echo "$2 was not told of"
    exit 1
fi

faults=$(for object; do check "$object"; done)
[[ -z $faults ]] && exit 0
echo "$faults"
exit 1
