// Reads a mesh file of any format.
#pragma once

#include "gr/mesh/import/readers.h"

namespace gr::importer {

// ending: one of gr::meshEndings. Throws Failure.
SourceMesh readMeshFile(std::string_view ending, std::string_view file, const OtherFile& others);

}  // namespace gr::importer
