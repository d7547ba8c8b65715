#include "grsh/resumption.h"

#include "core/parallel.h"
#include "grsh/picture_words.h"
#include "image/image_file.h"

#include <unistd.h>

#include <filesystem>

namespace grsh {

Resumption::Resumption(const RenderJob& job, const FileAccess& files, const gr::Scene& scene)
    : job_(job), files_(files), name_(job.file + ".grsh-state") {
    if (!job.settings.resume && !job.settings.keep) return;
    // A place where it may not be written is told before the first ray.
    files.toWrite(name_);
    words_ = stateWordsOf(job, scene);
}

void Resumption::read(render::Accumulation& accumulation) const {
    std::error_code failed;
    if (!job_.settings.resume || !std::filesystem::exists(name_, failed)) return;
    render::readState(files_.toReadBack(name_), words_, job_.settings.mostSamples(), accumulation);
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
        unlink(files_.toWrite(name_).path.c_str());
}

void Resumption::write(const render::Accumulation& accumulation) const {
    render::writeState(files_.toWrite(name_), words_, accumulation, core::threadCount(job_.settings.threads));
}

}  // namespace grsh
