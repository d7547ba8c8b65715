// OBJ files as words of Tcl, for tools: one parser for all.
#pragma once

#include <string>

namespace gr::importer {

// Writes to the standard output a dict:
//     vertices, normals   lists of {x y z}
//     parts               {name material faces ...}, as they follow each other; a face is a list of corners {vertex
//     normal},
//                         counted from 0, the normal being -1 where there is none
//     libraries, materials, leftOut   {line text ...}: what mtllib and usemtl name, and keywords of what is left out
//     absent              how many corners name what is not there
// Returns the program's exit code: 1 with the reason on the standard error where the file cannot be read.
int writeObjWords(const char* path);

}  // namespace gr::importer
