#include "render/settings.h"

#include "gr/accelerators/accelerator.h"
#include "image/curve.h"
#include "image/layer.h"
#include "render/transport/camera.h"
#include "render/transport/lanes_choice.h"

#include <array>

namespace render {
namespace {

constexpr std::array<core::Word, 2> integrators{"path", "report"};
constexpr core::Range atLeastOne{.least = 1, .most = 2147483647};
constexpr core::Range line{.least = 0, .most = 999999};
constexpr core::Range coordinate{.least = -1e18, .most = 1e18};

using S = RenderSettings;

const std::array<core::OptionRow<S>, 29> rows{{
    {.name = "accelerator",
     .member = &S::accelerator,
     .words = gr::acceleratorNames(),
     .defaultText = "auto; off with integrator report",
     .help = "how the object is found that a ray meets; every choice gives the same picture"},
    {.name = "globalillumination",
     .alias = "globalilllumination",
     .member = &S::globalIllumination,
     .help = "recursive path tracing, or primary rays and direct light only"},
    {.name = "antialiasing",
     .member = &S::antialiasing,
     .help = "jittered positions in the pixel, or all samples through its centre"},
    {.name = "pathlength",
     .member = &S::pathLength,
     .range = atLeastOne,
     .unit = "surface points",
     .help = "the most surface points on a path; 1 is direct light only"},
    {.name = "lookat",
     .member = &S::lookAt,
     .range = coordinate,
     .defaultText = "none",
     .help = "a point that the camera looks at, whatever view says; also written lookat {x y z} in place of {view}",
     // Told by the view and the focal distance that come of it.
     .inPicture = false},
    {.name = "projection",
     .member = &S::projection,
     .words = projectionNames(),
     .help = "from a point; by parallel rays, the picture 2 focaldistance tan(fov/2) high; or all round, 360 by 180 "
             "degrees whatever fov is, the view in the middle"},
    {.name = "depthoffield", .member = &S::depthOfField, .help = "a thin lens, or a pinhole"},
    {.name = "focaldistance",
     .member = &S::focalDistance,
     .range = {.least = 0, .most = 1e18, .leastIncluded = false},
     .defaultText = "1; with lookat that of its point",
     .help = "distance of the plane in focus, along the view direction"},
    {.name = "aperture",
     .alias = "aperature",
     .member = &S::aperture,
     .range = {.least = 0, .most = 1e18},
     .help = "radius of the lens; 0 is a pinhole"},
    {.name = "startline",
     .member = &S::startLine,
     .range = line,
     .defaultText = "0",
     .help = "first line to render, 0 at the top"},
    {.name = "stopline",
     .member = &S::stopLine,
     .range = line,
     .defaultText = "height-1",
     .help = "last line to render, itself included"},
    {.name = "startcolumn",
     .member = &S::startColumn,
     .range = line,
     .defaultText = "0",
     .help = "first column to render, 0 on the left"},
    {.name = "stopcolumn",
     .member = &S::stopColumn,
     .range = line,
     .defaultText = "width-1",
     .help = "last column to render, itself included"},
    {.name = "samplesperpixel",
     .member = &S::samplesPerPixel,
     .range = atLeastOne,
     .unit = "samples",
     .defaultText = "16; with noise or time 1048576",
     .help = "paths from the eye through each pixel; with noise or time the most there may be"},
    {.name = "noise",
     .member = &S::noise,
     .range = {.least = 0, .most = 1, .leastIncluded = false},
     .unit = "relative error",
     .defaultText = "none",
     .help = "goes on until the picture's estimated relative error is at most this",
     .inPicture = false},
    {.name = "time",
     .member = &S::time,
     .range = {.least = 0, .most = 1e9, .leastIncluded = false},
     .unit = "seconds",
     .defaultText = "none",
     .help = "goes on until it has rendered for so long; each pixel gets one sample at least",
     .inPicture = false},
    {.name = "samplesperlightsource",
     .member = &S::samplesPerLightSource,
     .range = atLeastOne,
     .unit = "samples",
     .help =
         "shadow rays to each area light from each surface point; with path, and more than four lights, to lights that "
         "chance picks"},
    {.name = "integrator",
     .member = &S::integrator,
     .words = integrators,
     .help = "how light is added up: path has far less noise, report is the report's own way, plain and slow"},
    {.name = "seed",
     .member = &S::seed,
     .range = {.least = 0},
     .help = "another seed gives other noise, the same one the same picture"},
    {.name = "background",
     .member = &S::background,
     .range = {.least = 0, .most = 1e18},
     .unit = "radiance",
     .help = "light of a ray that leaves the scene"},
    {.name = "exposure",
     .member = &S::exposure,
     .range = {.least = -64, .most = 64},
     .unit = "stops",
     .help = "each stop doubles what a .png shows; .exr and .pfm keep the radiance as it is"},
    {.name = "curve",
     .member = &S::curve,
     .words = image::curveNames(),
     .help = "what a .png's numbers go through: sRGB's curve, none, or Hable's filmic one and then sRGB's"},
    {.name = "layers",
     .member = &S::layers,
     .words = image::layerNames(),
     .help = "what an .exr file holds of each pixel beside its radiance",
     .inPicture = false},
    {.name = "lanes",
     .member = &S::lanes,
     .words = laneNames(),
     .help = "how many paths are followed at once, by what the processor has; the picture does not depend on it",
     .inPicture = false},
    {.name = "threads",
     .member = &S::threads,
     .range = {.least = 0, .most = 1024},
     .defaultText = "0, all cores",
     .help = "threads to render with; the picture does not depend on it",
     .inPicture = false},
    {.name = "progress",
     .member = &S::progress,
     .help = "a progress line on a terminal, and a summary at the end",
     .inPicture = false},
    {.name = "resume",
     .member = &S::resume,
     .help = "keeps what has been rendered in a file beside the picture, and goes on from there",
     .inPicture = false},
    {.name = "checkpoint",
     .member = &S::checkpoint,
     .range = {.least = 0.1, .most = 1e9},
     .unit = "seconds",
     .help = "how often resume writes that file",
     .inPicture = false},
    {.name = "keep",
     .member = &S::keep,
     .help = "leaves that file at the end, so that more samples can be added later",
     .inPicture = false},
}};

}  // namespace

std::span<const core::OptionRow<RenderSettings>> RenderSettings::options() {
    return rows;
}

}  // namespace render
