#!/usr/bin/env bash
# tests/docs/recipes.sh ROOT COMPILER FLAG...: follows recipes of docs/tour.md with a toy: changes the files that the
# recipe names and no other, and expects what walks the list to compile; then leaves a part out, and expects the
# compiler to say which.
set -euo pipefail
root=$1
shift
compile=("$@" -std=c++20 -fsyntax-only)

tree=$(mktemp -d)
# shellcheck disable=SC2064 # the name is wanted as it is now
trap "rm -rf '$tree'" EXIT
cp -r "$root/include" "$root/src" "$tree"
cd "$tree"
# The path integrator is compiled once for each width of lanes; one of them is enough here.
compile+=(-Iinclude -DGRSH_REAL=core::Lanes -DGRSH_PATH_INTEGRATOR=path_integrator)

fail() {
    echo "recipes: $1"
    exit 1
}

# What the recipe's row of docs/tour.md names must be what follow() changes here.
# named THING FILE...: the row names these files.
named() {
    local row file thing=$1
    shift
    row=$(grep -m1 "^| $thing | " "$root/docs/tour.md") || fail "docs/tour.md has no recipe for $thing"
    for file; do [[ $row == *"\`$file\`"* ]] || fail "the recipe for $thing does not name $file"; done
}

compiles() {
    local file
    for file; do "${compile[@]}" "$file" || fail "$file does not compile"; done
}

# refused TEXT FILE: it does not compile, and the compiler says TEXT.
refused() {
    local said
    if said=$("${compile[@]}" "$2" 2>&1); then fail "$2 compiles"; fi
    [[ $said == *"$1"* ]] || fail "the compiler does not say \"$1\" of $2, but: $said"
}

# change FILE SED-SCRIPT: it must change something.
change() {
    cp "$1" before
    sed -i "$2" "$1"
    ! cmp -s before "$1" || fail "nothing to change in $1"
}

# A shape: the disc under another name.
named "a shape" include/gr/shapes/cylinder.h include/gr/shape.h src/grsh/shape_commands.cpp
shape=include/gr/shapes/coin.h
sed 's/Disc/Coin/g; s/"disc"/"coin"/; s/"discs"/"coins"/' include/gr/shapes/disc.h >"$shape"
change include/gr/shape.h 's|#include "gr/shapes/cone.h"|#include "gr/shapes/coin.h"\n&|; s/\bDiscNode\b/&, CoinNode/'
refused "a shape of the list has no command here" src/grsh/shape_commands.cpp
change src/grsh/shape_commands.cpp '
    s/^Tcl_Obj\* makePlane/Tcl_Obj* makeCoin(Call\& call) {\n    return create(call, gr::CoinNode{});\n}\n\n&/
    s/^    {"gr_plane"/    {"gr_coin", "", "pname name", 2, 2, makeCoin, "makes a coin"},\n&/
    s/std::array<Command, \([0-9]*\)> rows/std::array<Command, \1 + 1> rows/'
compiles src/grsh/shape_commands.cpp src/grsh/stats_commands.cpp src/gr/{compile,solid,instance,database/print,fingerprint}.cpp \
    src/gr/{scene,accelerators/no_accelerator,accelerators/tree_accelerator}.cpp
echo '#include "gr/shape.h"' >shape.cpp
for part in intersect surfaceAt coordinatesAt reachUnder; do
    cp "$shape" whole
    change "$shape" "s/\b$part\b/not_$part/"
    refused "a shape lacks something" shape.cpp
    cp whole "$shape"
done
for part in placeIn text plural; do
    cp "$shape" whole
    change "$shape" "s/\b$part\b/not_$part/"
    refused "a shape's node lacks something" shape.cpp
    cp whole "$shape"
done

# A light: the point light under another name.
named "a light" include/gr/lights/point_light.h include/gr/light.h
light=include/gr/lights/glow.h
sed 's/PointLight/Glow/g' include/gr/lights/point_light.h >"$light"
change include/gr/light.h 's|#include "gr/lights/point_light.h"|#include "gr/lights/glow.h"\n&|; s/LightList<AreaLight/&, Glow/'
compiles src/gr/{compile,database/print,fingerprint}.cpp src/render/transport/{light_tree,report_integrator}.cpp
echo '#include "gr/light.h"' >light.cpp
for part in sample shadowEnd bounds power falloff text; do
    cp "$light" whole
    change "$light" "s/\b$part\b/not_$part/"
    refused "a light of the list lacks something" light.cpp
    cp whole "$light"
done

# A material: the diffuse one under another name.
named "a material" include/materials/diffuse.h include/materials/material.h
material=include/materials/chalk.h
sed 's/\bDiffuse\(\|Bsdf\)\b/Chalk\1/g; s/"diffuse";/"chalk";/' include/materials/diffuse.h >"$material"
change include/materials/material.h 's|#include "materials/dielectric.h"|#include "materials/chalk.h"\n&|; s/variant<Diffuse/&, Chalk/'
compiles src/grsh/material_commands.cpp src/gr/{compile,fingerprint}.cpp src/render/transport/{report,path}_integrator.cpp
echo '#include "materials/material.h"' >material.cpp
for part in typeName options canSample sampling at isAnisotropic interior albedo ambientReflectance eval pdfW sample; do
    cp "$material" whole
    change "$material" "/#include/! s/\b$part\b/not_$part/"
    refused "a material of the list lacks something" material.cpp
    cp whole "$material"
done
