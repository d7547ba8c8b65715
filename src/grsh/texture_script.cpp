#include "grsh/texture_script.h"

#include "core/memory.h"
#include "grsh/option_words.h"

namespace grsh {
namespace {

// The word behind the last `body`: the object itself, for Tcl compiles it once and knows its lines.
Tcl_Obj* bodyWord(const Call& call) {
    Tcl_Obj* body = nullptr;
    for (std::size_t i = 2; i + 1 < call.words.size(); i += 2)
        if (withoutDash(call.words.text(i)) == "body") body = call.words.object(i + 1);
    return body;
}

void setVariable(Tcl_Interp* interp, const char* name, double value) {
    if (Tcl_SetVar2Ex(interp, name, nullptr, Tcl_NewDoubleObj(value), TCL_LEAVE_ERR_MSG) == nullptr)
        throw ScriptEnded{TCL_ERROR};
}

// `return` ends the body as it does that of a procedure.
void evaluate(Call& call, Tcl_Obj* body) {
    const int code = Tcl_EvalObjEx(call.interp, body, 0);
    if (code == TCL_OK || code == TCL_RETURN) return;
    if (code == TCL_BREAK || code == TCL_CONTINUE) {
        const std::string word = code == TCL_BREAK ? "break" : "continue";
        throw core::Error("TEXTURE", "BODY", word, "the body must return a colour, not end by \"" + word + "\"");
    }
    if (code == TCL_ERROR)
        Tcl_AppendObjToErrorInfo(call.interp,
                                 Tcl_ObjPrintf("\n    (\"gr_texture\" body line %d)", Tcl_GetErrorLine(call.interp)));
    throw ScriptEnded{code};
}

void checkMemory(const materials::ScriptTexture& texture) {
    const double needed = double{texture.size.x} * double{texture.size.y} * sizeof(core::Rgbf);
    const double available = static_cast<double>(core::availableMemory());
    if (needed > available)
        throw core::Error("MEMORY", "PICTURE", core::optionText(texture.size),
                          "a texture of " + core::optionText(texture.size) + " texels takes " +
                              core::memoryText(needed) + " of memory; " + core::memoryText(available) + " are free");
}

}  // namespace

std::shared_ptr<const materials::Texels> runTextureScript(Call& call, const materials::ScriptTexture& texture) {
    checkMemory(texture);
    auto texels = std::make_shared<materials::Texels>();
    texels->width = static_cast<int>(texture.size.x);
    texels->height = static_cast<int>(texture.size.y);
    texels->colours.reserve(static_cast<std::size_t>(texels->width) * static_cast<std::size_t>(texels->height));
    const Value body = hold(bodyWord(call));
    constexpr core::Range amount{.least = 0, .most = 1e18};
    for (int y = 0; y < texels->height; ++y) {
        for (int x = 0; x < texels->width; ++x) {
            setVariable(call.interp, "u", (x + 0.5) / texels->width);
            setVariable(call.interp, "v", 1 - (y + 0.5) / texels->height);
            evaluate(call, body.get());
            texels->colours.push_back(colourFrom(Tcl_GetObjResult(call.interp), "what the body returns", amount));
        }
    }
    Tcl_ResetResult(call.interp);
    return texels;
}

}  // namespace grsh
