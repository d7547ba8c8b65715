// Tcl's values, held so that their references are counted.
#pragma once

#include <tcl.h>

#include <memory>
#include <string>
#include <string_view>

namespace grsh {

struct ReleaseValue {
    void operator()(Tcl_Obj* value) const { Tcl_DecrRefCount(value); }
};
using Value = std::unique_ptr<Tcl_Obj, ReleaseValue>;

inline Value hold(Tcl_Obj* value) {
    Tcl_IncrRefCount(value);
    return Value(value);
}

inline Value textValue(std::string_view text) {
    return hold(Tcl_NewStringObj(text.data(), static_cast<int>(text.size())));
}

// Bytes of the system's, as on the command line.
inline Value argumentValue(const std::string& argument) {
    Tcl_DString text;
    Tcl_ExternalToUtfDString(nullptr, argument.data(), static_cast<int>(argument.size()), &text);
    Value value = textValue({Tcl_DStringValue(&text), static_cast<std::size_t>(Tcl_DStringLength(&text))});
    Tcl_DStringFree(&text);
    return value;
}

inline std::string stringOf(Tcl_Obj* value) {
    int length = 0;
    const char* bytes = Tcl_GetStringFromObj(value, &length);
    return {bytes, static_cast<std::size_t>(length)};
}

}  // namespace grsh
