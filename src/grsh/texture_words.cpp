#include "grsh/texture_words.h"

#include "gr/database/database.h"
#include "grsh/words.h"

namespace grsh {

std::shared_ptr<const materials::Texture> textureFrom(Tcl_Obj* word, const Textures* textures) {
    return textures != nullptr ? textures->findTexture(textOf(word)) : nullptr;
}

namespace {

// Numbers and lists of them are meant for what they are.
bool mayBeName(Tcl_Obj* word) {
    double number = 0;
    int length = 0;
    return Tcl_ListObjLength(nullptr, word, &length) == TCL_OK && length == 1 &&
           Tcl_GetDoubleFromObj(nullptr, word, &number) != TCL_OK;
}

}  // namespace

void throwNoTexture(const core::Error& error, Tcl_Obj* word, const Textures* textures) {
    const std::string what(error.what());
    const std::string_view end = ", not ";
    const std::size_t at = what.rfind(end);
    if (textures == nullptr || !mayBeName(word) || at == std::string::npos) throw error;
    // A colour's name may be meant, and then is told already.
    const bool isTold = what.find("did you mean", at) != std::string::npos;
    const std::string hint = isTold ? "" : core::didYouMean(textOf(word), textures->textureNames());
    throw core::Error(error.topic, error.reason, error.word,
                      what.substr(0, at) + ", or a texture" + what.substr(at) + hint);
}

}  // namespace grsh
