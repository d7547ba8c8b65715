# The Cornell box with the numbers of the reference pictures: reference-a.gr, -bas.gr, -d.gr and -e.gr share it.

source [file join [file dirname [info script]] cornell.tcl]

namespace eval reference {
    proc room {parent} {
        cornell::room $parent {0.73 0.73 0.73} {0.65 0.05 0.05} {0.12 0.45 0.15} {17 12 4} 554
    }

    # Every path may meet `depth` surfaces. The samples lie all over the pixel: its value is the mean over its square.
    proc render {file depth args} {
        cornell::render $file 256 globalillumination on antialiasing on pathlength $depth samplesperpixel 256 \
            exposure 1 {*}$args
    }
}
