# grsh commands.tcl SCENE FILE ?OPTION VALUE ...?: renders SCENE into FILE, with these options before its own. Where FILE
# is empty, it prints the scene's commands instead, each on a line of its own, with tabs between its words.
set overrides [lassign $argv scene file]

rename gr_render render
proc gr_render {node itsFile width height eye view up fov args} {
    set words [list $node $::file $width $height $eye $view $up $fov {*}[dict merge $args $::overrides]]
    if {$::file eq ""} {record [list gr_render {*}$words] enter} else {render {*}$words}
}

proc record {words operation} {puts [join [lmap word $words {string map {\n { } \t { }} $word}] \t]}
if {$file eq ""} {
    foreach command [lsearch -all -inline -not [info commands gr_*] gr_render] {
        trace add execution $command enter record
    }
}
source $scene
