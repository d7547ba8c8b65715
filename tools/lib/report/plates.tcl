# The page's words: its rooms, what hangs in them, and the report's objectives. In texts, [id words] is a link to a plate
# and `word` is code.
namespace eval ::report {
    # A plate:
    # id         where links lead
    # label      its name in the report
    # shape      one picture; a pair, one over the other; a row of small ones; the plot
    # pictures   and for each what it shows, for who cannot see it
    # sides      of a pair: a word or two on each
    # text       what to look at
    variable rooms {
        {title "The final picture" intro {
            The report ends with a modelled animal in a scene that needs nearly everything the renderer can do. This page
            begins with ours.
        } plates {
            {id final label "Figure 7.1 and section 5.4" title "The jaguar" shape pair sides {rendered filtered}
            pictures {
                final "A clay jaguar on steps before a disc of brushed gold, between a mirror ball and a green glass ball."
                final_median "The same picture after the median filter: fine texture is a little softer."
            } text {
                The gold disc is brushed, and spreads its highlight like a fan. The green glass is deepest where it is
                thickest, the walls colour the stone and the clay, and the lens leaves what is far behind the jaguar
                blurred. Slide to the left for the report's remedy against noise, a median of 3 × 3 pixels: it takes
                single bright pixels away, and the finest lines with them. The less noise there is, the less there is
                to gain.
            }}
        }}
        {title "The Cornell box" intro {
            A room of known measures, a red and a green wall, one lamp. The report promises a Cornell box for most
            of its objectives.
        } plates {
            {id cornell1 label "cornell1 and cornell1-aa" title "Without and with antialiasing" shape pair
            sides {{through the centre} {all over the pixel}} crisp 1
            pictures {
                cornell1 "Two white blocks in a room with a red and a green wall. Edges are stepped."
                cornell1-aa "The same room. The edges of the blocks and of the lamp are smooth."
            } text {
                Follow the upper edge of the short block, or the lamp's outline: steps where every path goes through the
                pixel's centre, a clean line where the paths are spread over the pixel. The number of paths is the same.
                The white blocks and the floor are reddish on the left and greenish on the right, by light that comes
                from the walls alone.
            }}
            {id cornell2 label cornell2 title "Glass" shape one
            pictures {
                cornell2 "A clear glass ball and a blue glass block in the box. A bright spot lies below the ball."
            } text {
                The ball shows the room upside down and gathers the lamp's light in a bright spot below itself. The block
                turns bluer the longer the way through it is, by Beer's law. Light finds its way through glass to the
                lamp by chance alone, so what noise is left
                is a few glaring specks, the last to go.
            }}
            {id cornell3 label "cornell3-noimp and cornell3" title "Without and with importance sampling" shape pair
            sides {{everywhere alike} {where it reflects}}
            pictures {
                cornell3-noimp "A copper ball and a steel block in the box, covered in coarse, bright and dark grain."
                cornell3 "The same, with the ball and the block almost smooth."
            } text {
                The same material, the same number of paths. The steel block mirrors in a narrow cone: paths that leave it
                in all directions alike seldom find that cone, and leave black and glaring grains. Paths that go where
                the material reflects give a clean mirror. At every quality this pair keeps a fixed number of paths.
            }}
            {id cornell4 label cornell4 title "Everything at once" shape one
            pictures {
                cornell4 "A brushed metal ball, a varnished block and an amber glass ball in the box."
            } text {
                Brushed metal with a highlight drawn out to one side, varnish that mirrors the room at a low angle, amber
                glass that gathers yellow light on the floor. Every path goes on in the way that suits what it has met.
            }}
            {id dof label "nodof and dof" title "Without and with a lens" shape pair sides {pinhole lens}
            pictures {
                nodof "Five clay balls in a row that goes back into the box, all of them sharp."
                dof "The same balls through a lens: the middle one is sharp, the first and the last are blurred."
            } text {
                Through a pinhole all five balls are sharp. A lens is sharp at one distance, that of the ball in the
                middle; nearer and farther, edges spread out, most at the ball in front and at the red and green edges of
                the room.
            }}
        }}
        {title "The figures" intro {
            The report's third chapter explains each idea by a small picture. The scenes are new; what they are to show
            is not.
        } plates {
            {id soft-shadow label "Figure 3.2" title "A soft shadow" shape one
            pictures {
                soft-shadow "A cube on a light floor. Its shadow is sharp at the cube and blurred at its far end."
            } text {
                Where the cube stands on the floor its shadow has a sharp edge; the farther from the cube, the wider the
                passage from light to dark. There, the floor sees a part of the lamp.
            }}
            {id shirley label "Figure 3.3" title "One formula, three materials" shape one
            pictures {
                shirley "Three balls on a chequered floor: brushed metal, red varnish, dull red plaster."
            } text {
                Left only the highlight, right only the diffuse base, in the middle one over the other. The left ball is
                brushed: its two exponents differ, and the lamp's image becomes a long streak.
            }}
            {id dielectric label "Figure 3.4" title "Coloured glass" shape one
            pictures {
                dielectric "Three glass balls on a chequered floor: reddish, bluish and clear."
            } text {
                Three balls of the same glass but for what they absorb. The coloured ones are deepest in the middle, where
                the way through is longest, and pale at the rim.
            }}
            {id reflective label "Figure 3.7" title "A blurred mirror" shape one
            pictures {
                reflective "A mirror ball whose reflection of the chequered floor is a little blurred."
            } text {
                Every path leaves in the mirror's direction, turned at random by up to 5 degrees. The tiles close by stay
                legible, those farther off run into each other.
            }}
            {id refractive label "Figure 3.8" title "A ball as a lens" shape one
            pictures {
                refractive "A clear glass ball that shows the floor above and the sky below."
            } text {
                Refraction alone, without a reflection. The chequered floor stands above and the grey sky below: a ball of
                glass turns what is behind it upside down.
            }}
            {id importance label "Figure 3.9" title "With and without importance sampling" shape one
            pictures {
                importance "Two golden balls. The left one is smooth, the right one is covered in black and bright grain."
            } text {
                The same gold and the same 36 paths for each pixel. The paths of the left ball go where its material
                reflects, those of the right one anywhere.
            }}
        }}
        {title "The acceleration" intro {
            Each ray must find what it meets first. Testing every object takes time in proportion to their number; a grid
            lets a ray look only at what is near.
        } plates {
            {id performance label "performance2x2 to 5x5" title "4, 9, 16 and 25 balls" shape row
            pictures {
                performance2x2 "4 brown balls in a square."
                performance3x3 "9 brown balls in a square."
                performance4x4 "16 brown balls in a square."
                performance5x5 "25 brown balls in a square."
            } text {
                The balls always fill the same part of the picture, so that the number of objects is all that changes.
                These four are the report's own; the plot goes on from there.
            }}
            {id figure5.1 label "Figure 5.1" title "Seconds against spheres" shape plot
            pictures {
                figure5.1 "Seconds by number of spheres: a straight rise without acceleration, else nearly flat."
            } text {
                Both axes are logarithmic. Without acceleration the line rises in proportion to the number of spheres;
                with the report's grid, and with Embree's tree, it stays nearly flat.
            }}
        }}
    }

    # What the report set out to do, in its order: a name, its words (one misspelling mended),
    # where to see it, and the tests that measure it.
    variable objectives {
        {"Spatial subdivision" {A hierarchical spatial subdivision scheme is introduced as described in the specification.
            Performance measures are performed with and without the optimisation.}
            {The plot of [figure5.1 figure 5.1], for scenes like [performance these four].}}
        {"The character" {A scene including the character presented in the specification is modelled, exported to the
            scene description language format and rendered using the ray tracer.}
            {[final The final picture]. The animal is a model of our own.}}
        {"Antialiasing" {Antialiasing via supersampling is performed by the jittered grid approach. Sample images with and
            without the supersampling are presented.}
            {The edges of [cornell1 the two blocks].}}
        {"Soft shadows" {Area light sources produce soft shadows using Monte Carlo integration. Soft shadows are clearly
            visible in the Cornell box test image.}
            {Beside [cornell1 the blocks], and widening away from [soft-shadow the cube].}}
        {"Colour bleeding" {Indirect illumination via reflection, so called colour bleeding, is performed via path tracing
            and is clearly visible in the Cornell box test image.}
            {Red and green on [cornell1 the white blocks and the floor].}}
        {"Depth of field" {Depth of field is implemented [5] and clearly visible in a version of the Cornell box test
            image.}
            {[dof Five balls], one of them in focus; also in [final the final picture].}}
        {"Refraction" {Light transmission is implemented via refraction. The feature is clearly visible in the Cornell box
            test image.}
            {The room upside down in [cornell2 the ball]; most plainly in [refractive the lens].}}
        {"Beer's law" {Beer's law is implemented for attenuation through transmissive objects as described in [6]. The
            results are clearly visible in the Cornell box test image.}
            {[cornell2 The blue block], [dielectric the coloured balls], and the amber of [cornell4 cornell4].}}
        {"Ashikhmin and Shirley's material" {The BRDF described in [3] is used for lighting computations.
            Examples of the materials presented in [3] is clearly visible in the Cornell box test image.}
            {[cornell3 Copper and steel], [cornell4 brushed metal and varnish], [shirley three balls].}}
        {"Importance sampling" {The BRDF described in [3] is used for importance sampling. The Cornell box image with and
            without importance sampling is available.}
            {[cornell3 The steel block] and [importance two golden balls].}}
    }
}
