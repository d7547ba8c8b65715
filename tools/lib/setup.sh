# shellcheck shell=bash
# What the tools share. Sourced, never run: a tool lists its packages and calls set_up.

root=${BASH_SOURCE[0]%/tools/lib/*}
packages=(g++ cmake ninja-build tcl-dev libglm-dev libxsimd-dev libtbb-dev libembree-dev libpng-dev zlib1g-dev libopenexr-dev
    nlohmann-json3-dev libdraco-dev libmeshoptimizer-dev)

# All set-up output goes to standard error: standard output belongs to what the tool runs.
say() { echo "tools/${0##*/}: $*" >&2; }

# Prints those of the named Debian packages that are not installed.
missing_packages() {
    local installed name
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
    for name; do
        [[ $'\n'$installed$'\n' == *$'\n'"installed $name"$'\n'* ]] || echo "$name"
    done
}

# need package...: installs what is missing, or says what to do and fails.
need() {
    local missing=() as_root=()
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]})) || return 0

    say "missing Debian packages: ${missing[*]}"
    if ! command -v apt-get >/dev/null; then
        say "there is no apt-get here: install what these packages hold, then build with" \
            "\"cmake --preset release && cmake --build --preset release\""
        return 1
    fi
    local install=(apt-get install -y --no-install-recommends "${missing[@]}")
    if ((EUID != 0)); then
        if ! command -v sudo >/dev/null; then
            say "not root, and there is no sudo. Run this as root, then call tools/${0##*/} again:"
            echo "    apt-get update && ${install[*]}" >&2
            return 1
        fi
        as_root=(sudo)
    fi
    as_root+=(env DEBIAN_FRONTEND=noninteractive)
    # One unreachable source must not stop us: the install that follows tells whether it mattered.
    "${as_root[@]}" apt-get -q update >&2 || say "apt-get update failed; trying with the lists at hand"
    # A fresh machine often runs its own updates: wait for them.
    if ! "${as_root[@]}" "${install[@]}" -o DPkg::Lock::Timeout=600 >&2; then
        say "could not install. Run this as root, then call tools/${0##*/} again:"
        echo "    apt-get update && ${install[*]}" >&2
        return 1
    fi
}

# configure preset [OPTION...]: runs cmake where the build folder is absent, stale, or lacks an OPTION set ON.
configure() {
    local preset=$1 build=$root/build/$1 cache=$root/build/$1/CMakeCache.txt fresh=() options=() option
    shift
    for option; do
        grep -qs "^$option:.*=ON$" "$cache" || options+=("-D$option=ON")
    done
    # A checkout that was moved leaves a cache that names its old place.
    if [[ -e $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then fresh=(--fresh); fi
    if [[ ! -e $build/build.ninja || CMakePresets.json -nt $build/build.ninja ]] ||
        ((${#fresh[@]} + ${#options[@]})); then
        cmake --preset "$preset" --log-level=WARNING "${fresh[@]}" "${options[@]}" >&2
    fi
}

# compile preset [target...]: silent when there is nothing to build.
compile() {
    ninja -C "$root/build/$1" "${@:2}" 2>&1 |
        sed -u -e '/^ninja: Entering directory/d' -e '/^ninja: no work to do/d' \
            -e '/Re-checking globbed directories/d' >&2
}

link_grsh() {
    local target=build/release/bin/grsh
    [[ $(readlink "$root/grsh") == "$target" ]] || ln -sfn "$target" "$root/grsh"
}

# set_up preset "OPTION..." [target...]: packages, configuration and build, one caller at a time.
set_up() (
    cd "$root"
    mkdir -p build
    exec 9>build/.lock
    flock -w 1 9 || { say "waiting for another build"; flock 9; }
    need "${packages[@]}"
    # shellcheck disable=SC2086 # a list of words
    configure "$1" $2
    compile "$1" "${@:3}"
    [[ $1 != release ]] || link_grsh
) </dev/null # what is piped in is for grsh
