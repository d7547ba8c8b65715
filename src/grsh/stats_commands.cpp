#include "grsh/commands.h"
#include "grsh/dict.h"

#include <array>

namespace grsh {
namespace {

// A whole number, or 1e+30 and the like where instances of instances go beyond those that a double holds.
Tcl_Obj* objectsObject(double objects) {
    return objects < 0x1p53 ? countObject(static_cast<std::uint64_t>(objects)) : Tcl_NewDoubleObj(objects);
}

// How many nodes there are of each kind.
Tcl_Obj* nodesDict(const gr::DatabaseStatistics& statistics) {
    return [&]<class... Kinds>(std::type_identity<std::variant<Kinds...>>) {
        std::size_t kind = 0;
        return dictOf({{Kinds::plural.data(), countObject(statistics.nodes[kind++])}...});
    }(std::type_identity<gr::NodeContent>());
}

Tcl_Obj* stats(Call& call) {
    const gr::DatabaseStatistics statistics = call.session.database.statistics();
    const Value& lastRender = call.session.lastRender;
    return dictOf({{"nodes", nodesDict(statistics)},
                   {"objects", objectsObject(statistics.objects)},
                   {"meshes", countObject(statistics.meshes)},
                   {"triangles", countObject(statistics.triangles)},
                   {"materials", countObject(statistics.materials)},
                   {"lights", countObject(statistics.lights)},
                   {"bytes", countObject(statistics.nodeBytes + statistics.meshBytes + statistics.materialBytes)},
                   {"memory", dictOf({{"nodes", countObject(statistics.nodeBytes)},
                                      {"meshes", countObject(statistics.meshBytes)},
                                      {"materials", countObject(statistics.materialBytes)}})},
                   {"render", lastRender ? lastRender.get() : Tcl_NewDictObj()}});
}

constexpr std::array<Command, 1> rows{{
    {"gr_stats", "", "", 0, 0, stats,
     "returns how many nodes, objects and triangles there are, their bytes, and what the last gr_render returned"},
}};

}  // namespace

std::span<const Command> statsCommands() {
    return rows;
}

}  // namespace grsh
