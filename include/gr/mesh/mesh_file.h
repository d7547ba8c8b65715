// Meshes from files: OBJ, PLY, STL and glTF.
#pragma once

#include "core/open_below.h"
#include "core/option.h"
#include "gr/mesh/mesh_import.h"

#include <unordered_map>

namespace gr {

// What gr_mesh is asked for: one row each.
struct MeshSettings {
    double smooth = 0;  // degrees

    static std::span<const core::OptionRow<MeshSettings>> options();
};

// The meshes that were read. A file that is read again is the same polyhedron, as long as that is used and neither the
// file nor one that it names has changed.
class MeshFiles {
public:
    // path: of the file; name: as the script calls it, for messages. Throws core::Error for a file that cannot be read.
    // repairs: what was mended, where the file is not read for the first time nothing. below: where it lies, and all
    // that it names; null: anywhere.
    std::shared_ptr<const Polyhedron> read(const std::string& path, std::string_view name, MeshRepairs& repairs,
                                           const core::Folder* below = nullptr, const MeshSettings& settings = {});
    // Allocated for what is known of the files, without the polyhedra.
    std::size_t bytes() const;

private:
    struct Entry {
        std::weak_ptr<const Polyhedron> polyhedron;
        std::int64_t size, changed;  // changed: when, in nanoseconds
        std::vector<NamedFile> named;
    };
    // By what becomes of a file, and its own path, without links.
    std::unordered_map<std::string, Entry> entries_;
};

}  // namespace gr
