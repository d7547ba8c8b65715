# An MTL material as type and options of gr_material. thickness is that of the first part that has it.
proc obj2gr::materialWords {name material thickness} {
    set material [dict merge {Kd {0.5 0.5 0.5} Ks {0 0 0} Ke {0 0 0} Tf {1 1 1} Ns 0 Ni 1.5 d 1 illum 2} $material]
    dict with material {}
    if {[largest $Ke] > 0} {warn "material \"$name\" shines, and only its flat rectangles become lamps"}
    if {$illum in {4 6 7 9} || $d < 0.5} {return [glassWords $name $Ni $Tf $thickness]}
    if {$d < 1} {warn "material \"$name\" is a little transparent, d [format %g $d]: it becomes opaque"}
    if {$illum < 2 || [largest $Ks] == 0} {return [list diffuse diffuse [shown $Kd]]}
    set exponent [format %g [expr {min(max($Ns, 0), 1e6)}]]
    list shirley diffuse [shown $Kd] specular [shown $Ks] exp [list $exponent $exponent]
}

# What the filter Tf leaves of light becomes absorption that leaves as much behind the thickness.
proc obj2gr::glassWords {name n filter thickness} {
    if {$n <= 0} {
        warn "material \"$name\": an index of refraction of [format %g $n] becomes 1.5"
        set n 1.5
    }
    set words [list dielectric n [format %g $n]]
    if {[lindex [lsort -real $filter] 0] < 1} {
        lappend words beers [shown [lmap part $filter {expr {-log(max($part, 1e-3)) / $thickness}}]]
    }
    return $words
}
