# What scripts of tests/bad-safe find around them, in the temporary folder: their own folder "scene", the current one
# "work", and "outside", which is not theirs. Nothing here ever changes, whatever they do.

# A triangle whose numbers are in a file of their own.
proc gltf {buffer} {
    string map [list BUFFER $buffer] {{
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"uri": "BUFFER", "byteLength": 36}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
            "min": [0, 0, 0], "max": [1, 1, 0]}]
    }}
}

proc triangleNumbers {} {
    binary format r* {0 0 0 1 0 0 0 1 0}
}

proc writeBytes {file bytes} {
    set channel [open $file wb]
    puts -nonewline $channel $bytes
    close $channel
}

proc makeOutside {picture} {
    write outside/secret.tcl "puts secret-7f3a\nset secret secret-7f3a\n"
    write outside/secret.obj "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 3 2 4\n"
    write outside/secret.mtl "newmtl secret-7f3a\n"
    write outside/victim.png victim
    writeBytes outside/secret.bin secret-7f3a
    file copy $picture outside/secret.png
}

proc makeScene {picture} {
    write scene/lib.tcl "set lib read\n"
    write scene/model.obj "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    write scene/materials.obj "mtllib ../outside/secret.mtl\nusemtl secret-7f3a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    write scene/own.gltf [gltf own.bin]
    write scene/parent.gltf [gltf ../outside/secret.bin]
    write scene/absolute.gltf [gltf [file normalize outside/secret.bin]]
    write scene/link.gltf [gltf link.bin]
    write scene/evil.enc "# an encoding\nS\n003F 0 1\n"
    writeBytes scene/own.bin [triangleNumbers]
    file copy $picture scene/picture.png
    makeLinks
    foreach ending {tcl obj png} {exec mkfifo scene/pipe.$ending}
}

proc makeLinks {} {
    foreach {link target} {
        folder ../outside    chain folder            link.tcl ../outside/secret.tcl     link.obj ../outside/secret.obj
        zero.tcl /dev/zero   environ /proc/self/environ
        link.bin ../outside/secret.bin   link.png ../outside/secret.png   inside.tcl lib.tcl
    } {
        exec ln -s $target scene/$link
    }
    exec ln -s [file normalize outside/secret.tcl] scene/absolute.tcl
    exec ln -s ../outside work/out
    exec ln -s ../outside/victim.png work/link.png
    exec ln -s ../outside/victim.png work/kept.png.grsh-state
}

# Makes all of it in the current folder, anew.
proc makeFolders {picture} {
    file delete -force scene outside work
    file mkdir scene outside work
    write work/own.txt "secret-7f3a\n"
    makeOutside $picture
    makeScene $picture
}

# What there is below the current folder: names, kinds, permissions, sizes and sums of the contents.
proc snapshot {{folder .}} {
    set found {}
    foreach name [lsort [glob -nocomplain -directory $folder * .*]] {
        if {[file tail $name] in {. ..}} continue
        file lstat $name status
        set sum [expr {$status(type) eq "file" ? [zlib crc32 [contentBytes $name]] : ""}]
        lappend found [list $name $status(type) $status(mode) $status(size) $sum]
        if {$status(type) eq "directory"} {lappend found {*}[snapshot $name]}
    }
    return $found
}

proc contentBytes {file} {
    set channel [open $file rb]
    try {read $channel} finally {close $channel}
}
