#include "grsh/render_report.h"

#include "grsh/dict.h"
#include "grsh/progress.h"

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

Tcl_Obj* reportDict(const RenderReport& report, Tcl_Obj* file) {
    const render::RenderResult& result = report.result;
    const std::size_t acceleratorBytes = report.accelerator.bytes();
    return dictOf({{"file", file},
                   {"seconds", Tcl_NewDoubleObj(report.seconds)},
                   {"samples", countObject(result.samples)},
                   {"rays", raysDict(result.rays)},
                   {"tests", perRay(result.rays.traversal.tests, result.rays)},
                   {"cells", perRay(result.rays.traversal.cells, result.rays)},
                   {"accelerator", textObject(acceleratorText(report.accelerator))},
                   {"resolution", resolutionList(report.accelerator)},
                   {"build", Tcl_NewDoubleObj(report.buildSeconds)},
                   {"rendering", Tcl_NewDoubleObj(report.renderSeconds)},
                   {"bytes", countObject(report.sceneBytes + acceleratorBytes + report.pictureBytes)},
                   {"memory", dictOf({{"scene", countObject(report.sceneBytes)},
                                      {"accelerator", countObject(acceleratorBytes)},
                                      {"picture", countObject(report.pictureBytes)}})},
                   {"threads", Tcl_NewIntObj(result.threads)},
                   {"stopped", textObject("samplesperpixel")},
                   {"dropped", countObject(result.droppedSamples)}});
}

void printSummary(const RenderReport& report, const RenderJob& job) {
    std::string line = job.file + ": " + std::to_string(job.width) + " x " + std::to_string(job.lines()) + " pixels, " +
                       std::to_string(job.settings.samplesPerPixel) + " samples each, " + durationText(report.seconds) +
                       ", " + rateText(report.result.rays.total(), report.seconds);
    if (report.result.droppedSamples > 0)
        line += ", " + std::to_string(report.result.droppedSamples) + " samples dropped (not finite)";
    line += ", " + acceleratorText(report.accelerator);
    std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace grsh
