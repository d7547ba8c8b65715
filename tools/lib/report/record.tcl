# Records: what is known of a picture that is done, a dict in a file beside it. By its checksums a later call sees
# whether the picture is still what would be rendered.
namespace eval ::report {
    proc contents {file} {
        set channel [open $file rb]
        try {
            read $channel
        } finally {
            close $channel
        }
    }

    proc text {file} {encoding convertfrom utf-8 [contents $file]}

    # The file is there whole or as it was.
    proc writeWhole {file text} {
        set temporary $file.[pid]
        try {
            set channel [open $temporary w]
            fconfigure $channel -encoding utf-8 -translation lf
            puts -nonewline $channel $text
            # A full disk may show only now.
            close $channel
            file rename -force $temporary $file
        } on error {message options} {
            catch {close $channel}
            file delete $temporary
            set code [dict get $options -errorcode]
            error "cannot write \"$file\": [expr {[lindex $code 0] eq "POSIX" ? [lindex $code 2] : $message}]"
        }
    }

    proc checksum {file} {format %08x [zlib crc32 [contents $file]]}

    # Files and their checksums, those below the root by their path from there.
    proc checksums {files} {
        variable root
        set sums {}
        foreach file [lsort -unique $files] {
            set name [expr {[string first $root/ $file] == 0 ? [string range $file [string length $root/] end] : $file}]
            lappend sums $name [checksum $file]
        }
        return $sums
    }

    # What decides how it is rendered, beside the files.
    proc recipe {name quality} {
        variable pictures
        variable qualityTable
        set picture [dict remove [dict get $pictures $name] cost]
        list $picture [dict get $qualityTable $quality] [checksum [info nameofexecutable]]
    }

    # The record, or nothing where there is none that can be read.
    proc readRecord {folder name} {
        set file [recordFile $folder $name]
        if {![file exists $file] || [catch {text $file} record] || [catch {dict size $record}]} {return {}}
        return $record
    }

    proc isDone {folder name quality} {
        variable root
        set record [readRecord $folder $name]
        if {![dict exists $record recipe] || [dict get $record recipe] ne [recipe $name $quality]} {return 0}
        set sums [dict create {*}[dict get $record sources] [pictureFile $folder $name] [dict get $record picture]]
        dict for {file sum} $sums {
            set file [file join $root $file]
            if {![file isfile $file] || [checksum $file] ne $sum} {return 0}
        }
        return 1
    }
}
