#include "grsh/render_report.h"

#include "grsh/dict.h"
#include "grsh/progress.h"
#include "render/accumulate/noise.h"

#include <cstdio>

namespace grsh {
namespace {

Tcl_Obj* raysDict(const render::RayCounts& rays) {
    return dictOf({{"camera", countObject(rays.camera)},
                   {"shadow", countObject(rays.shadow)},
                   {"diffuse", countObject(rays.diffuse)},
                   {"reflective", countObject(rays.reflective)},
                   {"refractive", countObject(rays.refractive)}});
}

Tcl_Obj* perRay(std::uint64_t count, const render::RayCounts& rays) {
    const std::uint64_t total = std::max<std::uint64_t>(rays.total(), 1);
    return Tcl_NewDoubleObj(static_cast<double>(count) / static_cast<double>(total));
}

// {x y z}, or an empty list.
Tcl_Obj* resolutionList(const gr::Accelerator& accelerator) {
    Tcl_Obj* list = Tcl_NewListObj(0, nullptr);
    if (const auto resolution = accelerator.resolution())
        for (const int cells : *resolution) Tcl_ListObjAppendElement(nullptr, list, Tcl_NewIntObj(cells));
    return list;
}

std::string acceleratorText(const gr::Accelerator& accelerator) {
    return accelerator.description() + (accelerator.reason.empty() ? "" : ", " + accelerator.reason);
}

}  // namespace

std::string stoppedText(render::StoppedBy stoppedBy) {
    switch (stoppedBy) {
        case render::StoppedBy::noise:
            return "noise";
        case render::StoppedBy::time:
            return "time";
        case render::StoppedBy::interrupt:
            return "interrupt";
        case render::StoppedBy::samplesPerPixel:
            break;
    }
    return "samplesperpixel";
}

Tcl_Obj* reportDict(const RenderReport& report, const RenderJob& job) {
    const render::RenderResult& result = report.result;
    return dictOf({{"file", argumentValue(job.file).get()},
                   {"seconds", Tcl_NewDoubleObj(report.seconds)},
                   {"samples", countObject(result.samples)},
                   {"samplesperpixel", Tcl_NewIntObj(result.samplesPerPixel)},
                   {"noise", result.noise ? Tcl_NewDoubleObj(*result.noise) : Tcl_NewObj()},
                   {"rays", raysDict(result.rays)},
                   {"tests", perRay(result.rays.traversal.tests, result.rays)},
                   {"cells", perRay(result.rays.traversal.cells, result.rays)},
                   {"accelerator", textObject(acceleratorText(report.accelerator))},
                   {"resolution", resolutionList(report.accelerator)},
                   {"build", Tcl_NewDoubleObj(report.buildSeconds)},
                   {"rendering", Tcl_NewDoubleObj(report.renderSeconds)},
                   {"bytes", countObject(report.sceneBytes + report.acceleratorBytes + report.pictureBytes)},
                   {"memory", dictOf({{"scene", countObject(report.sceneBytes)},
                                      {"accelerator", countObject(report.acceleratorBytes)},
                                      {"picture", countObject(report.pictureBytes)}})},
                   {"threads", Tcl_NewIntObj(result.threads)},
                   {"stopped", textObject(stoppedText(result.stoppedBy))},
                   {"dropped", countObject(result.droppedSamples)}});
}

void printSummary(const RenderReport& report, const RenderJob& job) {
    const render::RenderResult& result = report.result;
    std::string line = job.file + ": " + std::to_string(job.columns()) + " x " + std::to_string(job.lines()) +
                       " pixels, " + std::to_string(result.samplesPerPixel) + " samples each, ";
    if (result.noise) line += "relative error " + render::noiseText(*result.noise) + ", ";
    if (job.settings.isOpenEnded() || result.stoppedBy == render::StoppedBy::interrupt)
        line += "stopped by " + stoppedText(result.stoppedBy) + ", ";
    line += durationText(report.seconds) + ", " + rateText(result.rays.total() - result.earlierRays, report.seconds);
    if (result.droppedSamples > 0)
        line += ", " + std::to_string(result.droppedSamples) + " samples dropped (not finite)";
    line += ", " + acceleratorText(report.accelerator);
    std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace grsh
