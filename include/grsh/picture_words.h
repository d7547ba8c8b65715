// What a picture is made from, as words: for the picture's own text, and for the file of what has been rendered of it.
#pragma once

#include "gr/scene.h"
#include "grsh/render_job.h"
#include "image/image.h"
#include "render/accumulate/state_file.h"
#include "render/render.h"

namespace grsh {

// What made the picture; nothing that another run of the same render would have different. script: its name.
image::Metadata metadataOf(const RenderJob& job, const gr::Scene& scene, const render::RenderResult& result,
                           const std::string& script);

// What must be the same for a render to be gone on with.
render::StateWords stateWordsOf(const RenderJob& job, const gr::Scene& scene);

}  // namespace grsh
