// EXT_meshopt_compression: buffer views that meshoptimizer has packed.
#pragma once

#include "gr/mesh/import/gltf/json_object.h"

namespace gr::importer {

// extension: the object of that name. Throws Failure, before it asks for memory, where so few bytes cannot become what
// is announced.
std::string unpackMeshopt(const JsonObject& extension, std::string_view packed);

}  // namespace gr::importer
