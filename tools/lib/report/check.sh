# shellcheck shell=bash
# What tools/report --check does; sourced by it.

# check_page [--folder path]: opens the page in headless Chromium, 360 and 1280 pixels wide, light and dark. Prints what
# is wrong with it, as check.js finds it and as the browser's console tells. Pictures of it go to build/report-check/.
check_page() {
    local folder=$root/docs/report count=0 failed=0 scheme width
    if [[ $# == 2 && $1 == --folder ]]; then
        folder=$2
    elif (($# > 0)); then
        say "usage: tools/report --check [--folder path]"
        return 2
    fi
    [[ -f $folder/index.html ]] || { say "there is no $folder/index.html; tools/report writes it" && return 1; }
    need chromium

    local shots=$root/build/report-check
    rm -rf "$shots"
    mkdir -p "$shots"
    # All pictures at once: the check does not scroll.
    sed 's/ loading="lazy"//' "$folder/index.html" >"$shots/index.html"
    cp "$root/tools/lib/report/check.js" "$shots"
    # Chromium's own numbers: 0 is dark, 1 light.
    for scheme in light dark; do
        for width in 360 1280; do
            check_at "$shots" "$scheme" "$width" || failed=$((failed + 1))
            count=$((count + 1))
        done
    done
    rm -r "$shots"/{index.html,check.js,check.html,profile}
    ((failed == 0)) || { say "$failed of $count checks of $folder/index.html failed" && return 1; }
    say "$folder/index.html is right: 360 and 1280 pixels wide, light and dark; look at build/report-check/*.png"
}

# check_at folder scheme width: the page in a frame, since a window of Chromium is 500 pixels wide at least.
check_at() {
    local shots=$1 scheme=$2 width=$3 height=16000 said log=$1/log
    local browser=(chromium --headless --disable-gpu --hide-scrollbars --allow-file-access-from-files
        --user-data-dir="$shots/profile" --enable-logging=stderr --timeout=60000)
    [[ $scheme == light ]] && browser+=(--blink-settings=preferredColorScheme=1)
    [[ $scheme == dark ]] && browser+=(--blink-settings=preferredColorScheme=0)
    # Chromium refuses its sandbox to root.
    if ((EUID == 0)); then browser+=(--no-sandbox); fi

    # host of the frame, as high as it is asked for.
    write_host() {
        echo "<!DOCTYPE html><title>check</title><body style='margin:0'><iframe id=frame src=index.html" \
            "style='border:0;display:block;width:${width}px;height:$1px'></iframe>$2"
    }
    write_host 800 '<script src=check.js></script>' >"$shots/check.html"
    said=$("${browser[@]}" --dump-dom "file://$shots/check.html" 2>"$log" |
        grep -o 'check: [^<]*' || true)
    grep -o 'CONSOLE.*' "$log" | sed "s/^/$scheme, $width wide: /" >&2 && return 1
    if [[ $said != "check: right, "* ]]; then
        echo "$scheme, $width wide: ${said:-the page did not answer}" >&2
        return 1
    fi
    height=${said##*, }
    write_host "$height" "" >"$shots/check.html"
    "${browser[@]}" --window-size="$((width < 500 ? 500 : width)),$height" \
        --screenshot="$shots/$scheme-$width.png" "file://$shots/check.html" 2>"$log" >&2 || cat "$log" >&2
    rm -f "$log"
}
