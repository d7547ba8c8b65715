// A box with 100 holes through it under a square lamp, direct light only: tests/bench/holes.gr, for POV-Ray 3.7.
// Its z axis points the other way. POV-Ray is faster without a union of the holes than with one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
    location <0, 7, -9>
    right <4/3, 0, 0>
    angle 45
    look_at <0, 0, 0>
}
background { rgb <0.1, 0.15, 0.25> }

// With such a fade_distance it is 64/d^2.
light_source {
    <-4, 8, -3>
    rgb 3200
    fade_distance 0.1 fade_power 2
    area_light <2, 0, 0>, <0, 0, 2>, 2, 2 jitter
}

#declare Diffuse = finish { ambient 0 diffuse 0.8 }
plane { y, -1 pigment { rgb 1 } finish { Diffuse } }
difference {
    box { <-4, -0.5, -4>, <4, 0.5, 4> }
    #declare I = 0;
    #while (I < 100)
        #declare X = 0.8 * mod(I, 10) - 3.6;
        #declare Z = 0.8 * div(I, 10) - 3.6;
        cylinder { <X, -1, Z>, <X, 1, Z>, 0.3 }
        #declare I = I + 1;
    #end
    pigment { rgb <0.9, 0.5, 0.2> }
    finish { Diffuse }
}
