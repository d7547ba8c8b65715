#!/usr/bin/env bash
# tests/docs/places.sh ROOT: fails, naming file and line, where README.md or docs/*.md point to what is not there:
#     [text](path)          a link to a file, as seen from the file that links
#     `src/gr/scene.cpp`    a file or a folder, as seen from the root
#     | `src/gr/scene.cpp` | `surfaceAt`, ... |    a row of a table: the file holds the words of the next cell
# tests/docs/places.sh --self-test: plants such faults and expects each to be found.
# shellcheck disable=SC2016 # backquotes are what is looked for
set -euo pipefail

# Prints "line:match" for every match of a pattern in a file.
matches() { grep -noP "$1" "$2" || true; }

# check ROOT: prints a line for each fault; returns whether there was none.
check() {
    local root=$1 count=0 faults=0 file line text words word
    fault() {
        echo "$file:$line: $1"
        faults=$((faults + 1))
    }
    cd "$root"
    for file in README.md docs/*.md; do
        while IFS=: read -r line text; do
            count=$((count + 1))
            [[ -e $(dirname "$file")/$text ]] || fault "links to \"$text\", which is not there"
        done < <(matches '\]\(\K(?![a-z]+:|#)[^)#]+' "$file")
        while IFS=: read -r line text; do
            count=$((count + 1))
            [[ -e $text ]] || fault "names \"$text\", which is not there"
        done < <(matches '`(\./)?\K(src|include|tests|tools|scenes|docs)/[\w./-]*' "$file")
        while IFS=: read -r line text; do
            [[ $text =~ ^\`([^\`]+)\`\ *\|(.*)$ ]] || continue
            text=${BASH_REMATCH[1]}
            words=$(grep -o '`[^`]*`' <<<"${BASH_REMATCH[2]}" | tr -d '`' || true)
            while read -r word; do
                [[ -z $word || ! -f $text ]] || grep -qwF -- "$word" "$text" || fault "\"$text\" has no \"$word\""
            done <<<"$words"
        done < <(matches '`(src|include|tests)/[^`|]+` *\|[^|]+' "$file")
    done
    if ((count == 0)); then echo "$root: found nothing to check" && return 1; fi
    ((faults == 0))
}

self_test() {
    local tree
    tree=$(mktemp -d)
    # shellcheck disable=SC2064 # the name is wanted as it is now
    trap "rm -rf '$tree'" EXIT
    mkdir -p "$tree"/{docs,src/gr}
    echo 'void pack(Ray ray) {}' >"$tree/src/gr/scene.cpp"
    good='See [tour](docs/tour.md#hops), [home](https://example.org), `src/gr/scene.cpp` and `src/gr/`.'
    printf '%s\n' "$good" '| `src/gr/scene.cpp` | `pack`, `Ray` | `other` |' >"$tree/README.md"
    echo '[up](../README.md)' >"$tree/docs/tour.md"
    check "$tree"

    # plant FILE TEXT MESSAGE: TEXT at the end of FILE is the tree's only fault.
    plant() {
        local said before line
        before=$(<"$tree/$1")
        echo "$2" >>"$tree/$1"
        line=$(grep -c '' "$tree/$1")
        if said=$(check "$tree"); then echo "self-test: not found: $2" && exit 1; fi
        if [[ $said != "$1:$line: $3" ]]; then echo "self-test: expected \"$1:$line: $3\", got: $said" && exit 1; fi
        echo "$before" >"$tree/$1"
    }
    plant README.md '[a](docs/a.md)' 'links to "docs/a.md", which is not there'
    plant docs/tour.md '[a](docs/tour.md)' 'links to "docs/tour.md", which is not there'
    plant README.md 'run `./tools/run x`' 'names "tools/run", which is not there'
    plant docs/tour.md '`src/gr/accelerators/grid.cpp`' 'names "src/gr/accelerators/grid.cpp", which is not there'
    plant docs/tour.md '| 1 | `src/gr/scene.cpp` | `Ray`, `pac` |' '"src/gr/scene.cpp" has no "pac"'

    rm "$tree"/docs/*.md && echo nothing | tee "$tree/README.md" >"$tree/docs/a.md"
    if (check "$tree") >/dev/null; then echo "self-test: a tree that names nothing passed" && exit 1; fi
}

case ${1-} in
    --self-test) self_test ;;
    '' | -*) echo "usage: tests/docs/places.sh ROOT | --self-test" >&2 && exit 2 ;;
    *) check "$1" ;;
esac
