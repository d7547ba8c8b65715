# shellcheck shell=bash
# What tools/compare and tools/reference share: installs the renderers that are asked for, and runs a Python program.
packages+=(python3-venv)
# shellcheck disable=SC2154 # ../setup.sh sets root
venv=$root/build/compare

# The word behind an option, or else a default: word_behind OPTION DEFAULT WORD...
word_behind() {
    local option=$1 found=$2
    shift 2
    while (($#)); do
        case $1 in
            "$option") found=${2-} ;;
            "$option"=*) found=${1#*=} ;;
        esac
        shift
    done
    echo "$found"
}

# need_wheels MODULE...: installs from PyPI what build/compare does not hold.
need_wheels() {
    local module missing=()
    [[ -x $venv/bin/pip ]] || /usr/bin/python3 -m venv "$venv" >&2
    for module; do compgen -G "$venv/lib/python3*/site-packages/$module" >/dev/null || missing+=("$module"); done
    ((${#missing[@]} == 0)) || "$venv/bin/pip" install --quiet --disable-pip-version-check "${missing[@]}" >&2
}

# set_up_renderers "a,list,of,them": and grsh.
set_up_renderers() {
    set_up release "" grsh
    need_wheels numpy OpenEXR
    if [[ ,$1, == *,cycles,* ]]; then
        # Debian's Blender runs Debian's Python, without what is installed here.
        need blender python3-numpy || { say "Blender's module from PyPI then" && need_wheels bpy; }
    fi
    if [[ ,$1, == *,mitsuba-* ]]; then need_wheels mitsuba; fi
    # LLVM 14, Debian 12's own, fails on AVX-512.
    if [[ ,$1, == *,mitsuba-llvm,* && -z ${DRJIT_LIBLLVM_PATH-} ]]; then
        need libllvm19
        DRJIT_LIBLLVM_PATH=$(/sbin/ldconfig -p | sed -n 's/.*libLLVM[-.].*19.* => //p' | head -n 1)
        export DRJIT_LIBLLVM_PATH
    fi
}

# run PROGRAM WORD...: a Python program of this folder.
run() {
    TOOL=${0##*/} PYTHONDONTWRITEBYTECODE=1 exec "$venv/bin/python" "$root/tools/lib/compare/$1" "${@:2}"
}
