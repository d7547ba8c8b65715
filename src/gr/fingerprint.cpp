#include "gr/fingerprint.h"

#include "gr/mesh/polyhedron.h"

#include <bit>
#include <unordered_map>

namespace gr {
namespace {

class Hash {
public:
    void add(std::uint64_t word) {
        state_ = (state_ ^ word) * 0x9E3779B97F4A7C15;
        state_ ^= state_ >> 32;
    }
    void add(float x) { add(std::uint64_t{std::bit_cast<std::uint32_t>(x)}); }
    void add(const core::Vec3f& v) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    void add(const std::string& text) {
        for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
        add(std::uint64_t{text.size()});
    }
    void add(const core::Transform& map) {
        for (const core::Vec3f& row : {map.x, map.y, map.z, map.translation}) add(row);
    }
    void add(const SkyGrid* sky) {
        add(std::uint64_t(sky->width()));
        add(std::uint64_t(sky->height()));
        for (const core::Rgbf& radiance : sky->radiances()) add(radiance);
    }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0;
};

void addValue(Hash& hash, const core::Textured<core::Rgbf>& colour) {
    if (colour.texture != nullptr) hash.add(colour.texture->fingerprint);
}
void addValue(Hash& hash, const core::ColourPair& pair) {
    for (const auto& colour : pair) addValue(hash, colour);
}
void addValue(Hash& hash, const core::ColourStops& stops) {
    for (const core::ColourStop& stop : stops) addValue(hash, stop.colour);
}
void addValue(Hash&, const auto&) {}

void addTexels(Hash& hash, const materials::Picture& picture) {
    hash.add(std::uint64_t{static_cast<std::uint32_t>(picture.texels->width)} << 32 |
             static_cast<std::uint32_t>(picture.texels->height));
    for (const core::Rgbf& colour : picture.texels->colours) hash.add(colour);
}
void addTexels(Hash&, const materials::Mapping&) {}

void addMaterial(Hash& hash, const materials::Material& material) {
    hash.add(std::uint64_t{material.index()});
    const auto add = [&]<class M>(const M& m) {
        for (const auto& row : M::options()) hash.add(core::optionText(row, m));
    };
    std::visit(add, material);
    for (const materials::TextureUse& use : materials::textureUses(material)) hash.add(use.texture->fingerprint);
}

void addPolyhedron(Hash& hash, const Polyhedron& polyhedron) {
    for (std::uint32_t i = 0; i < polyhedron.triangleCount(); ++i)
        for (int corner = 0; corner < 3; ++corner) hash.add(polyhedron.vertex(i, corner));
    for (const PackedNormal normal : polyhedron.normals()) hash.add(std::uint64_t{normal});
    hash.add(std::uint64_t{polyhedron.triangleCount()});
}

using Numbers = std::unordered_map<const Polyhedron*, std::uint64_t>;

void addInstance(Hash& hash, const Instance& instance, const Numbers& polyhedra) {
    hash.add(instance.place.worldFromObject());
    hash.add(std::uint64_t{instance.shape.index()} << 32 | instance.material);
    const auto addShape = [&]<class S>(const S& shape) {
        if constexpr (std::is_same_v<S, const Polyhedron*>)
            hash.add(polyhedra.at(shape));
        else if constexpr (std::is_same_v<S, const Csg*>)
            shape->tree().forEachNumber([&](std::uint32_t number) { hash.add(std::uint64_t{number}); });
        else if constexpr (std::is_same_v<S, Square>)
            hash.add(std::uint64_t{shape.light});
        else
            std::apply([&](const auto&... part) { (hash.add(part), ...); }, S::parts(shape));
    };
    std::visit(addShape, instance.shape);
}

}  // namespace

std::uint64_t fingerprint(const materials::Texture& texture) {
    Hash hash;
    hash.add(std::uint64_t{texture.type.index()});
    std::visit(
        [&]<class T>(const T& t) {
            for (const core::OptionRow<T>& row : T::options()) {
                hash.add(core::optionText(row, t));
                std::visit([&](auto member) { addValue(hash, t.*member); }, row.member);
            }
            addTexels(hash, t);
        },
        texture.type);
    return hash.value();
}

std::uint64_t fingerprint(const Scene& scene) {
    Hash hash;
    hash.add(core::Vec3f(scene.origin));
    for (const materials::Material& material : scene.materials) addMaterial(hash, material);
    Numbers polyhedra;
    for (const auto& polyhedron : scene.polyhedra) {
        polyhedra.emplace(polyhedron.get(), polyhedra.size());
        addPolyhedron(hash, *polyhedron);
    }
    for (const Instance& instance : scene.instances) addInstance(hash, instance, polyhedra);
    scene.lights.forEachKind([&]<class Light>(const std::vector<Light>& lights, std::size_t) {
        hash.add(std::uint64_t{lights.size()});
        const auto addAll = [&](const auto&... part) { (hash.add(part), ...); };
        for (const Light& light : lights) std::apply(addAll, Light::parts(light));
    });
    return hash.value();
}

}  // namespace gr
