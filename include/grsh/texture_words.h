// Names of textures among a command's words.
#pragma once

#include "core/error.h"
#include "core/textured.h"

#include <tcl.h>

#include <memory>

namespace gr {
class Database;
}

namespace grsh {

// Where textures have their names.
using Textures = gr::Database;

// The texture that the word names, or null. textures: null where none may stand.
std::shared_ptr<const materials::Texture> textureFrom(Tcl_Obj* word, const Textures* textures);

// Throws the error that tells what a value may be, for a word that names no texture either: with the spelling nearest
// to it, of colours' names and textures'.
[[noreturn]] void throwNoTexture(const core::Error& error, Tcl_Obj* word, const Textures* textures);

}  // namespace grsh
