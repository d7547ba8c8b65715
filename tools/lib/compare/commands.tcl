# grsh commands.tcl SCENE FILE ?OPTION VALUE ...?: renders SCENE into FILE, with these options before its own. Where FILE
# is empty, it prints the scene's commands instead, each on a line of its own, with tabs between its words.
set overrides [lassign $argv scene file]

rename gr_render render
proc gr_render {node itsFile width height eye view args} {
    if {$view eq "lookat"} {set args [lassign $args point]}
    set args [lassign $args up fov]
    # Another build of grsh may have no gr_default.
    set options [dict merge [expr {[info commands gr_default] eq "" ? {} : [gr_default]}] $args]
    if {$view eq "lookat"} {dict set options lookat $point}
    set options [dict merge $options $::overrides]
    # Other renderers are told which way to look, and what is in focus.
    if {[dict exists $options lookat]} {
        set view [lmap there [dict get $options lookat] here $eye {expr {$there - $here}}]
        set distance [expr {sqrt([tcl::mathop::+ {*}[lmap x $view {expr {double($x) * $x}}]])}]
        set options [dict merge [dict create focaldistance $distance] [dict remove $options lookat]]
    }
    set words [list $node $::file $width $height $eye $view $up $fov {*}$options]
    if {$::file eq ""} {record [list gr_render {*}$words] enter} else {render {*}$words}
}

proc record {words operation} {puts [join [lmap word $words {string map {\n { } \t { }} $word}] \t]}
if {$file eq ""} {
    foreach command [info commands gr_*] {
        if {$command ni {gr_render gr_default}} {trace add execution $command enter record}
    }
}
source $scene
