#!/usr/bin/env bash
# tests/includes.sh ROOT: fails, naming file and line, where an include runs against the arrows
#     core <- image <- materials <- gr <- render <- grsh
# (a module may include itself and what is left of it), or where Tcl is included outside grsh.
# tests/includes.sh --self-test: plants such includes and expects each to be found.
set -euo pipefail

modules=(core image materials gr render grsh)

rank() {
    local i
    for i in "${!modules[@]}"; do
        if [[ ${modules[i]} == "$1" ]]; then echo "$i" && return; fi
    done
    return 1
}

# check ROOT: prints a line for each fault; returns whether there was none.
check() {
    local root=$1 count=0 faults=0 file line text module mine theirs
    fault() {
        echo "$file:$line: $1"
        faults=$((faults + 1))
    }
    cd "$root"
    while IFS=: read -r file line text; do
        count=$((count + 1))
        module=${file#*/}
        module=${module%%/*}
        if ! mine=$(rank "$module"); then
            fault "\"$module\" is none of the modules ${modules[*]}"
        elif [[ ! $text =~ include[[:space:]]*[\"\<]([^\"\>]+)[\"\>] ]]; then
            fault "no file name to check in: $text"
        else
            text=${BASH_REMATCH[1]}
            if [[ $text == *..* ]]; then
                fault "\"$text\" climbs out of its folder: write it as \"module/name.h\""
            elif [[ $module != grsh && $text =~ (^|/)tcl[A-Za-z]*\.h$ ]]; then
                fault "$module includes \"$text\": only grsh may include Tcl"
            elif [[ $text == */* ]] && theirs=$(rank "${text%%/*}") && ((theirs > mine)); then
                fault "$module includes \"$text\": $module may not include ${text%%/*}"
            fi
        fi
    done < <(grep -rnE '^[[:space:]]*#[[:space:]]*include' include src || true)
    if ((count == 0)); then echo "$root: found no includes under include/ and src/" && return 1; fi
    ((faults == 0))
}

self_test() {
    local tree
    tree=$(mktemp -d)
    # shellcheck disable=SC2064 # the name is wanted as it is now
    trap "rm -rf '$tree'" EXIT

    # expect FILE LINE WORDS...: the tree's only fault is at FILE:LINE, and its message holds WORDS.
    expect() {
        local said
        if said=$(check "$tree"); then echo "self-test: not found: $1: $3" && exit 1; fi
        if [[ $said != "$1:$2: "*"$3"* || $said == *$'\n'* ]]; then
            echo "self-test: expected one fault, $1:$2: ... $3 ..., got: $said" && exit 1
        fi
    }
    # plant FILE TEXT WORDS: TEXT as the second line of FILE is found, and its absence again is not.
    plant() {
        mkdir -p "$tree/${1%/*}"
        printf '#pragma once\n%s\n' "$2" >"$tree/$1"
        expect "$1" 2 "$3"
        rm "$tree/$1"
        check "$tree"
    }

    if (check "$tree") >/dev/null 2>&1; then echo "self-test: an empty tree passed" && exit 1; fi

    mkdir -p "$tree"/{include,src}/{core,materials,gr,render,grsh}
    printf '#include <tcl.h>\n#include "commands.h"\n#include "render/render.h"\n' >"$tree/src/grsh/main.cpp"
    printf '  # include "core/vec.h"\n// #include "gr/scene.h"\n#include <glm/glm.hpp>\n' >"$tree/include/materials/a.h"
    check "$tree"

    local i
    for ((i = 0; i + 1 < ${#modules[@]}; ++i)); do
        local left=${modules[i]} right=${modules[i + 1]}
        plant "include/$left/bad.h" "#include \"$right/x.h\"" "$left may not include $right"
        plant "src/$left/bad.cpp" "  #  include <$right/x.h>" "$left may not include $right"
        plant "src/$left/bad.cpp" '#include <tcl.h>' 'only grsh may include Tcl'
    done
    plant include/core/bad.h '#include "grsh/progress.h"' 'core may not include grsh'
    plant src/render/bad.cpp '#include <tcl8.6/tclInt.h>' 'only grsh may include Tcl'
    plant src/core/bad.cpp '#include "../gr/grid.h"' 'climbs out of its folder'
    plant src/gr/bad.cpp '#include HEADER' 'no file name to check'
    plant src/extra/bad.cpp '#include <map>' 'is none of the modules'
}

case ${1-} in
    --self-test) self_test ;;
    '' | -*) echo "usage: tests/includes.sh ROOT | --self-test" >&2 && exit 2 ;;
    *) check "$1" ;;
esac
