// What has been rendered of a picture, kept in a file beside it.
#pragma once

#include "grsh/file_access.h"
#include "grsh/render_job.h"
#include "render/accumulate/state_file.h"
#include "render/render.h"

namespace grsh {

class Resumption {
public:
    Resumption(const RenderJob& job, const FileAccess& files, const gr::Scene& scene);

    // Where the picture is to be resumed and there is such a file. Throws core::Error where that is of another picture.
    void read(render::Accumulation& accumulation) const;
    // Now and then while it is rendered. A file that cannot be written is told of, once, and does not stop the render.
    // The accumulation must outlive what is returned.
    render::Checkpoints checkpoints(Call& call, const render::Accumulation& accumulation);
    // At the end: what is needed of the file stays. isPublished: whether the picture is in its place.
    void end(const render::RenderResult& result, const render::Accumulation& accumulation, bool isPublished) const;

private:
    void write(const render::Accumulation& accumulation) const;

    const RenderJob& job_;
    const FileAccess& files_;
    std::string name_;
    render::StateWords words_;
    bool isTold_ = false;
};

}  // namespace grsh
