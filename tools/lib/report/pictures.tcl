# What is rendered: the pictures of the report's data folder and its figures.
namespace eval ::report {
    # What each quality makes of a scene's gr_render:
    # size      the most pixels along an edge; 0: as the scene says
    # samples   the most samples per pixel, whatever it asks for; 0: as it says
    # noise     where there is more than this, go on until there is not; 0: as it says. atMost: but with no more samples
    variable qualityTable {
        draft  {size 480 samples 64 noise 0    atMost 0}
        normal {size 0   samples 0  noise 0    atMost 0}
        final  {size 0   samples 0  noise 0.01 atMost 8192}
    }
    proc qualities {} {dict keys $::report::qualityTable}

    # Each picture and how it is made:
    # kind      scene: scenes/NAME.gr is run. median: `from`, filtered by gr_median. plot: tools/figure5.1
    # keep      1: it shows what noise its number of samples leaves; `final` changes nothing
    # cost      seconds at draft, normal and final with two cores, by which the progress is reckoned
    variable pictures {
        final          {kind scene cost {6 1200 1200}}
        final_median   {kind median from final n 3 cost {0.1 0.5 0.5}}
        cornell1       {kind scene cost {0.9 3.5 13}}
        cornell1-aa    {kind scene cost {0.9 3.5 13}}
        cornell2       {kind scene cost {1.7 6.7 220}}
        cornell3       {kind scene keep 1 cost {1.2 4.8 4.8}}
        cornell3-noimp {kind scene keep 1 cost {0.7 2.9 2.9}}
        cornell4       {kind scene cost {1.3 5.1 170}}
        dof            {kind scene cost {0.8 3.4 7}}
        nodof          {kind scene cost {0.8 3 3}}
        soft-shadow    {kind scene cost {0.2 0.3 0.3}}
        shirley        {kind scene cost {0.8 3.4 9}}
        dielectric     {kind scene cost {1 4 18}}
        reflective     {kind scene cost {0.5 1.1 40}}
        refractive     {kind scene cost {0.6 1.4 10}}
        importance     {kind scene keep 1 cost {0.4 0.4 0.4}}
        performance2x2 {kind scene cost {0.2 0.2 0.5}}
        performance3x3 {kind scene cost {0.2 0.2 0.6}}
        performance4x4 {kind scene cost {0.2 0.2 0.8}}
        performance5x5 {kind scene cost {0.3 0.3 0.9}}
        figure5.1      {kind plot cost {5 5 300}}
    }
    proc names {} {dict keys $::report::pictures}

    proc cost {name quality} {lindex [dict get $::report::pictures $name cost] [lsearch [qualities] $quality]}

    # The picture's file, and what is written beside it.
    proc pictureFile {folder name} {
        file join $folder $name[expr {[dict get $::report::pictures $name kind] eq "plot" ? ".svg" : ".png"}]
    }
    proc recordFile {folder name} {file join $folder $name.record}

    # The script that makes it, from the root.
    proc scriptOf {name} {
        switch [dict get $::report::pictures $name kind] {
            scene {return scenes/$name.gr}
            median {return tools/lib/report/render.tcl}
            plot {return tests/bench/figure5.1.tcl}
        }
    }
}
