#include "gr/mesh/import/gltf/document.h"

#include "gr/mesh/import/gltf/words.h"
#include "gr/mesh/import/text.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace gr::importer {
namespace {

using namespace std::string_view_literals;

// Those that are done here, and those that change no face. A name with '*' at its end stands for all that begin so.
constexpr std::array knownExtensions{"KHR_mesh_quantization"sv,
                                     "KHR_draco_mesh_compression"sv,
                                     "EXT_meshopt_compression"sv,
                                     "EXT_mesh_gpu_instancing"sv,
                                     "KHR_materials_*"sv,
                                     "KHR_texture_*"sv,
                                     "KHR_lights_punctual"sv,
                                     "KHR_animation_pointer"sv,
                                     "KHR_xmp*"sv,
                                     "KHR_technique*"sv,
                                     "EXT_texture_*"sv,
                                     "EXT_lights_*"sv,
                                     "EXT_mesh_features"sv,
                                     "EXT_instance_features"sv,
                                     "EXT_structural_metadata"sv,
                                     "CESIUM_primitive_outline"sv,
                                     "ADOBE_materials_*"sv,
                                     "MSFT_texture_dds"sv,
                                     "MSFT_lod"sv};

bool isKnown(std::string_view name) {
    return std::any_of(knownExtensions.begin(), knownExtensions.end(), [&](std::string_view known) {
        return known.ends_with('*') ? name.starts_with(known.substr(0, known.size() - 1)) : name == known;
    });
}

void checkExtensions(const JsonObject& root) {
    for (const nlohmann::json& value : root.list("extensionsRequired")) {
        if (!value.is_string()) throw Failure("its \"extensionsRequired\" is not a list of names");
        const std::string& name = value.get_ref<const std::string&>();
        if (isKnown(name)) continue;
        std::string known;
        for (const std::string_view each : knownExtensions) known += (known.empty() ? "" : ", ") + std::string(each);
        throw Failure("it requires the extension " + inQuotes(name) +
                      ", which is not among those that are known: " + known);
    }
}

// As a text even where it is a number, as in the first files of glTF 1.
std::string versionOf(const JsonObject& asset) {
    const nlohmann::json* version = asset.find("version");
    return version != nullptr && version->is_number() ? version->dump() : asset.text("version");
}

void checkVersion(const JsonObject& root) {
    const std::optional<JsonObject> asset = root.object("asset");
    if (!asset) throw Failure("it has no \"asset\", as a glTF 2 file does");
    const std::string version = versionOf(*asset), least = asset->text("minVersion");
    if (version == "1" || version.starts_with("1.")) throw Failure("it is glTF 1, and only glTF 2 is read");
    if (version != "2" && !version.starts_with("2."))
        throw Failure("it is glTF of version " + inQuotes(version) + ", and only glTF 2 is read");
    if (!least.empty() && least != "2.0")
        throw Failure("it needs a reader of glTF " + inQuotes(least) + ", and this one is of \"2.0\"");
}

}  // namespace

GltfDocument::GltfDocument(std::string_view text) {
    if (isUtf16(text)) throw Failure("it is UTF-16 text, and glTF's is UTF-8");
    json_ = std::make_unique<nlohmann::json>(parseJson(text));
    root_.emplace(*json_, "");
    checkVersion(*root_);
    checkExtensions(*root_);
}

GltfDocument::~GltfDocument() = default;

std::size_t GltfDocument::count(const GltfKind& kind) const {
    return root_->list(kind.list).size();
}

JsonObject GltfDocument::item(const GltfKind& kind, std::size_t index) const {
    return JsonObject(root_->list(kind.list)[index], kind.word + (" " + std::to_string(index)));
}

std::size_t GltfDocument::checked(const JsonObject& from, const char* key, const nlohmann::json& value,
                                  const GltfKind& kind) const {
    const std::optional<std::uint64_t> number = wholeNumber(value);
    if (!number) throw Failure(from.subjectOf(key) + " names no " + kind.word + " by its number");
    if (*number >= count(kind))
        throw Failure(from.subject() + " names " + kind.word + " " + std::to_string(*number) + " of " +
                      std::to_string(count(kind)));
    return *number;
}

std::optional<std::size_t> GltfDocument::named(const JsonObject& from, const char* key, const GltfKind& kind) const {
    const nlohmann::json* value = from.find(key);
    if (value == nullptr) return {};
    return checked(from, key, *value, kind);
}

std::size_t GltfDocument::neededNamed(const JsonObject& from, const char* key, const GltfKind& kind) const {
    const std::optional<std::size_t> index = named(from, key, kind);
    if (!index) throw Failure(from.subject() + " has no " + inQuotes(key));
    return *index;
}

std::vector<std::size_t> GltfDocument::allNamed(const JsonObject& from, const char* key, const GltfKind& kind) const {
    std::vector<std::size_t> indices;
    for (const nlohmann::json& value : from.list(key)) indices.push_back(checked(from, key, value, kind));
    return indices;
}

}  // namespace gr::importer
