# The Cornell box: the room that the scenes cornell*.gr share.
#
# The original is a real box, built at Cornell University to compare photographs of it with rendered pictures. Its
# measures are in millimetres, and so are ours. It has no front wall: the camera looks in from there, along +z. In the
# picture +x is to the left and +y is up.
#
# What these procs make hangs below the node that they are given. They all return the path of what they made.

namespace eval cornell {
    # The empty room with its lamp: the colours of its walls, the lamp's radiance, and the height at which it hangs.
    proc room {parent {white {0.75 0.73 0.70}} {red {0.63 0.06 0.05}} {green {0.14 0.45 0.10}} {light {18 14.5 10}}
            {height 554.9}} {
        foreach colour {white red green} {gr_material $colour diffuse diffuse [set $colour]}
        set room [gr_transform $parent room]
        gr_surfaceproperty $room white

        # Eight corners, and the walls as lists of corners: floor, ceiling and back in one mesh, one more for each
        # coloured wall. Neighbouring walls have their corners at the very same places, so no light slips through.
        set corners {
            {0 0 0}   {555 0 0}   {555 0 555}   {0 0 555}
            {0 555 0} {555 555 0} {555 555 555} {0 555 555}
        }
        gr_polyhedron $room shell $corners {{0 3 2 1} {4 5 6 7} {3 7 6 2}}
        gr_surfaceproperty [gr_polyhedron $room left $corners {{1 2 6 5}}] red
        gr_surfaceproperty [gr_polyhedron $room right $corners {{0 4 7 3}}] green

        # gr_als_planar makes a square lamp that shines down. Scaled along x it becomes 130 wide and stays 105 deep. It
        # hangs a hair below the ceiling: in the same plane, the two could not be told apart.
        set lamp [gr_als_planar $room lamp $light {0 0 0} 105]
        gr_translate $lamp [list 278 $height 279.5]
        gr_scale $lamp [list [expr {130 / 105.}] 1 1]
        return $room
    }

    # A block with a square base on the floor. One edge of the base goes from the point `from` to the point `to`, each
    # an {x z}, and the base lies on the far side of it.
    proc block {parent name from to height} {
        lassign $from x z
        lassign $to toX toZ
        set side [expr {hypot($toX - $x, $toZ - $z)}]
        set degrees [expr {atan2($z - $toZ, $toX - $x) * 180 / acos(-1)}]

        # Read from the bottom: make the box at the origin, turn it about the y axis, move it into its place. The
        # transform that is written last acts first.
        set block [gr_box $parent $name {0 0 0} [list $side $height $side]]
        gr_translate $block [list $x 0 $z]
        gr_rotate $block y $degrees
        return $block
    }

    # A ball on the floor.
    proc ball {parent name x z radius material} {
        set ball [gr_sphere $parent $name [list $x $radius $z] $radius]
        gr_surfaceproperty $ball $material
        return $ball
    }

    # Renders everything, a square picture, from where the original is photographed.
    proc render {file size args} {
        gr_render : $file $size $size {278 278 -800} {0 0 1} {0 1 0} 38 {*}$args
    }
}
