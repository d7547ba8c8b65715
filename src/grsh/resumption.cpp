#include "grsh/resumption.h"

#include "core/parallel.h"

#include <unistd.h>

namespace grsh {

Resumption::Resumption(const RenderJob& job, render::StateWords words)
    : job_(job), path_(job.file + ".grsh-state"), words_(std::move(words)) {}

void Resumption::read(render::Accumulation& accumulation) const {
    if (job_.settings.resume) render::readState(path_, words_, job_.settings.mostSamples(), accumulation);
}

render::Checkpoints Resumption::checkpoints(Call& call, const render::Accumulation& accumulation) {
    if (!job_.settings.resume) return {};
    return {job_.settings.checkpoint, [this, &call, &accumulation] {
                try {
                    write(accumulation);
                } catch (const core::Error& error) {
                    if (!isTold_) warn(call, std::string("gr_render: ") + error.what() + "; rendering goes on");
                    isTold_ = true;
                }
            }};
}

void Resumption::end(const render::RenderResult& result, const render::Accumulation& accumulation,
                     bool isPublished) const {
    const bool isOver =
        isPublished && result.stoppedBy != render::StoppedBy::interrupt && result.stoppedBy != render::StoppedBy::time;
    if (job_.settings.keep || (job_.settings.resume && !isOver))
        write(accumulation);
    else if (job_.settings.resume)
        unlink(path_.c_str());
}

void Resumption::write(const render::Accumulation& accumulation) const {
    render::writeState(path_, words_, accumulation, core::threadCount(job_.settings.threads));
}

}  // namespace grsh
