// Materials and lights, which scripts know by name.

#include "gr/database/auto_name.h"
#include "gr/database/database.h"

#include <algorithm>

namespace gr {
namespace {

template<class Map>
std::vector<std::string_view> namesOf(const Map& map) {
    std::vector<std::string_view> names;
    for (const auto& entry : map) names.push_back(entry.first);
    // A map of hashes has no order of its own, and a suggestion must not depend on one.
    std::sort(names.begin(), names.end());
    return names;
}

// topic: MATERIAL or LIGHT; kind: the same in small letters.
template<class Map>
auto& findIn(Map& map, std::string_view name, std::string_view topic, std::string_view kind) {
    const auto found = map.find(std::string(name));
    if (found == map.end())
        throw core::Error(
            std::string(topic), "UNKNOWN", std::string(name),
            "no such " + std::string(kind) + " \"" + std::string(name) + "\"" + core::didYouMean(name, namesOf(map)));
    return found->second;
}

// The name to make something by. last: the number of the last one that #auto named, which this moves on.
template<class Map>
std::string newName(const Map& map, std::string_view name, std::string_view kind, std::size_t& last) {
    if (name != autoName) return std::string(name);
    AutoName free = nextFree(kind, last, [&](const std::string& word) { return map.contains(word); });
    last = free.number;
    return std::move(free.name);
}

}  // namespace

std::string Database::addMaterial(std::string_view name, const materials::Material& material, std::string_view words) {
    if (name.empty()) throw core::Error("MATERIAL", "NAME", "", "a name must not be empty");
    const std::string key = newName(materials_, name, "material", lastMaterial_);
    const auto [entry, isNew] = materials_.try_emplace(key, NamedMaterial{key, material, std::string(words)});
    if (!isNew && (words.empty() || entry->second.words != words))
        throw core::Error("MATERIAL", "EXISTS", key, "material \"" + key + "\" already exists; -redefine changes it");
    return key;
}

std::string Database::addLight(std::string_view name, const NamedLight& light, std::string_view kind) {
    if (name.empty()) throw core::Error("LIGHT", "NAME", "", "a name must not be empty");
    const std::string key = newName(lights_, name, kind, lastLights_[kind]);
    if (!lights_.try_emplace(key, light).second)
        throw core::Error("LIGHT", "EXISTS", key, "light \"" + key + "\" already exists; -redefine changes it");
    return key;
}

bool Database::checkNewTexture(std::string_view name, std::string_view words) const {
    if (name.empty()) throw core::Error("TEXTURE", "NAME", "", "a name must not be empty");
    const auto found = textures_.find(std::string(name));
    if (found == textures_.end()) return false;
    if (found->second.words != words)
        throw core::Error("TEXTURE", "EXISTS", std::string(name),
                          "texture \"" + std::string(name) + "\" already exists");
    return true;
}

std::string Database::addTexture(std::string_view name, std::shared_ptr<const materials::Texture> texture,
                                 std::string_view words) {
    std::string key = newName(textures_, name, "texture", lastTexture_);
    if (!checkNewTexture(key, words)) textures_.emplace(key, NamedTexture{std::move(texture), std::string(words)});
    return key;
}

std::shared_ptr<const materials::Texture> Database::findTexture(std::string_view name) const {
    const auto found = textures_.find(std::string(name));
    return found == textures_.end() ? nullptr : found->second.texture;
}

std::vector<std::string_view> Database::textureNames() const {
    return namesOf(textures_);
}

NamedMaterial& Database::namedMaterial(std::string_view name) {
    return findIn(materials_, name, "MATERIAL", "material");
}

NamedLight& Database::namedLight(std::string_view name) {
    return findIn(lights_, name, "LIGHT", "light");
}

const NamedLight& Database::light(std::string_view name) const {
    return findIn(lights_, name, "LIGHT", "light");
}

std::vector<std::string> Database::lightNames() const {
    const auto names = namesOf(lights_);
    return {names.begin(), names.end()};
}

void Database::redefineMaterial(std::string_view name, const materials::Material& material, std::string_view words) {
    NamedMaterial& named = namedMaterial(name);
    std::string copied(words);
    named.words.swap(copied);
    named.material = material;
}

void Database::redefineLight(std::string_view name, const NamedLight& light) {
    namedLight(name) = light;
}

void Database::removeMaterial(std::string_view name) {
    const NamedMaterial& material = namedMaterial(name);
    if (material.users > 0) {
        const Node* user = &root_;
        while (user->material != &material) user = nextInSubtree(user, &root_);
        throw core::Error("MATERIAL", "USED", material.name,
                          "material \"" + material.name + "\" is used by \"" + user->path() + "\"");
    }
    materials_.erase(std::string(name));
}

void Database::removeLight(std::string_view name) {
    namedLight(name);
    lights_.erase(std::string(name));
}

void Database::setMaterial(std::string_view path, std::string_view name) {
    Node& node = get(path);
    const NamedMaterial& material = namedMaterial(name);
    ++material.users;
    if (node.material != nullptr) --node.material->users;
    node.material = &material;
}

bool Database::hasTextures() const {
    return std::any_of(materials_.begin(), materials_.end(),
                       [](const auto& entry) { return !materials::textureUses(entry.second.material).empty(); });
}

bool Database::hasInteriors() const {
    return std::any_of(materials_.begin(), materials_.end(), [](const auto& entry) {
        return std::visit([](const auto& material) { return material.interior().has_value(); }, entry.second.material);
    });
}

}  // namespace gr
