// Links: mesh_readers gr
#include "fuzz/mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::readMesh(bytes, size, gr::importer::readPly);
    return 0;
}
