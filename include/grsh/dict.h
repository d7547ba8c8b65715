// Tcl's dicts, made from their keys and values.
#pragma once

#include <tcl.h>

#include <cstdint>
#include <initializer_list>
#include <utility>

namespace grsh {

inline Tcl_Obj* dictOf(std::initializer_list<std::pair<const char*, Tcl_Obj*>> entries) {
    Tcl_Obj* dict = Tcl_NewDictObj();
    for (const auto& [key, value] : entries) Tcl_DictObjPut(nullptr, dict, Tcl_NewStringObj(key, -1), value);
    return dict;
}

inline Tcl_Obj* countObject(std::uint64_t count) {
    return Tcl_NewWideIntObj(static_cast<Tcl_WideInt>(count));
}

}  // namespace grsh
