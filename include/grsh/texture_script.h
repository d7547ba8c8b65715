// Textures that a script computes.
#pragma once

#include "grsh/commands.h"
#include "materials/textures/picture.h"

#include <memory>

namespace grsh {

// Runs the body once for each texel, where the command stands, line after line from the top, with the variables u and v
// set to the texel's middle; they are left as the last one has them. Throws core::Error, or ScriptEnded with the line
// in the body, where that fails or returns no colour.
std::shared_ptr<const materials::Texels> runTextureScript(Call& call, const materials::ScriptTexture& texture);

}  // namespace grsh
