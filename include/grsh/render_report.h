// What gr_render says of a render that is done.
#pragma once

#include "gr/accelerators/accelerator.h"
#include "grsh/render_job.h"
#include "render/render.h"

namespace grsh {

struct RenderReport {
    const render::RenderResult& result;
    const gr::Accelerator& accelerator;
    double buildSeconds, renderSeconds, seconds;  // of the accelerator, of the rays, of everything
    std::size_t sceneBytes, acceleratorBytes, pictureBytes;  // the accelerator's with what the integrator adds
};

// file: the picture's name as the script has it.
Tcl_Obj* reportDict(const RenderReport& report, const RenderJob& job);
// A line on standard error.
void printSummary(const RenderReport& report, const RenderJob& job);

// The name of the option that ended a render.
std::string stoppedText(render::StoppedBy stoppedBy);

}  // namespace grsh
