// The sky that gr_render is given as a texture or a picture.
#pragma once

#include "gr/lights/sky_grid.h"
#include "grsh/render_job.h"

#include <memory>

namespace grsh {

// Looks the texture up all round, or reads the picture; null where there is no environment.
std::shared_ptr<const gr::SkyGrid> readEnvironment(const RenderJob& job, const FileAccess& files,
                                                   const gr::Database& database);

// Throws where there are an environment and a background, both of which are all that lies around a scene.
void checkEnvironment(const render::RenderSettings& settings);

}  // namespace grsh
