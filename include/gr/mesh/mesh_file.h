// Meshes from files: OBJ, PLY, STL and glTF.
#pragma once

#include "core/open_below.h"
#include "gr/mesh/polyhedron.h"

#include <unordered_map>

namespace gr {

// A file announces how much it holds before it does. Throws core::Error, whose text is the reason, for one that holds
// less: nobody is to reserve memory for what is not there.
void checkAnnounced(std::string_view file, std::string_view ending);

// The meshes that were read. A file that is read again is the same polyhedron, as long as that is used and the file
// has not changed.
class MeshFiles {
public:
    // path: of the file; name: as the script calls it, for messages. Throws core::Error for a file that cannot be read.
    // repairs: what was mended, where the file is not read for the first time nothing. below: where it lies, and all
    // that it names; null: anywhere.
    std::shared_ptr<const Polyhedron> read(const std::string& path, std::string_view name, MeshRepairs& repairs,
                                           const core::Folder* below = nullptr);
    // Allocated for what is known of the files, without the polyhedra.
    std::size_t bytes() const;

private:
    struct Entry {
        std::weak_ptr<const Polyhedron> polyhedron;
        std::uintmax_t size;
        std::int64_t changed;  // when, in nanoseconds
    };
    std::unordered_map<std::string, Entry> entries_;  // by the files' own paths, without links
};

}  // namespace gr
