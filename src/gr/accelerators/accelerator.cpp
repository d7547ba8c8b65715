#include "gr/accelerators/accelerator.h"

#include "gr/scene.h"

#include <algorithm>
#include <array>

namespace gr {
namespace {

struct Row {
    core::Word name;
    std::unique_ptr<Accelerator> (*make)(const Scene& scene, Objects objects, int threads, bool manyRays);
};

constexpr std::array<Row, 5> rows{{
    {"off", [](const Scene& scene, Objects objects, int, bool) { return makeNoAccelerator(scene, objects); }},
    {"on", [](const Scene& s, Objects objects, int threads, bool) { return makeGridAccelerator(s, objects, threads); }},
    {"grid",
     [](const Scene& s, Objects objects, int threads, bool) { return makeGridAccelerator(s, objects, threads); }},
    {"embree",
     [](const Scene& s, Objects objects, int threads, bool) { return makeEmbreeAccelerator(s, objects, threads); }},
    {"auto", makeFastestAccelerator},
}};

}  // namespace

namespace {

// Operands are for their CSG objects to test.
std::vector<std::uint32_t> allOf(const Scene& scene) {
    std::vector<std::uint32_t> all;
    all.reserve(scene.instances.size());
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
        if (!scene.instances[i].isOperand) all.push_back(i);
    return all;
}

// No box holds what has no end: that is tested by itself, before all others.
class WithEndless final : public Accelerator {
public:
    WithEndless(const Scene& scene, Objects endless, std::unique_ptr<Accelerator> others)
        : endless_(makeNoAccelerator(scene, endless)), others_(std::move(others)) {
        reason = others_->reason;
    }

    std::optional<Hit> intersect(const core::Rayf& ray, TraversalCounts& counts) const override {
        const std::optional<Hit> first = endless_->intersect(ray, counts);
        if (!first) return others_->intersect(ray, counts);
        // What is just as near must be found, too: it may have been made first.
        core::Rayf rest = ray;
        rest.tMax = std::min(std::nextafter(first->t, core::infinity), ray.tMax);
        const std::optional<Hit> other = others_->intersect(rest, counts);
        return other && other->isBefore(*first) ? other : first;
    }
    bool occluded(const core::Rayf& ray, TraversalCounts& counts) const override {
        return endless_->occluded(ray, counts) || others_->occluded(ray, counts);
    }
    std::size_t bytes() const override { return endless_->bytes() + others_->bytes(); }
    std::string description() const override { return others_->description(); }
    std::optional<std::array<int, 3>> resolution() const override { return others_->resolution(); }

private:
    std::unique_ptr<Accelerator> endless_, others_;
};

// Whether testing every object is fastest: docs/performance.md tells how that was measured.
bool isFew(const Scene& scene, Objects objects, bool manyRays) {
    // One ray is tested against four objects before a tree's first box is.
    if (!manyRays) return scene.objectCount() <= 20;
    std::size_t count = 0;
    for (const std::uint32_t i : objects) count += partsOf(scene.instances[i].shape);
    return count <= 16;
}

}  // namespace

std::unique_ptr<Accelerator> makeNoAccelerator(const Scene& scene) {
    return makeNoAccelerator(scene, allOf(scene));
}

// Few objects are tested before a tree's first box is; a grid is the fastest where objects lie evenly; else many are
// found best by Embree, where it is installed.
std::unique_ptr<Accelerator> makeFastestAccelerator(const Scene& scene, Objects objects, int threads, bool manyRays) {
    std::unique_ptr<Accelerator> fastest;
    std::string reason = "chosen for " + std::to_string(scene.objectCount()) + " objects";
    if (isFew(scene, objects, manyRays)) {
        fastest = makeNoAccelerator(scene, objects);
    } else if (!manyRays && (fastest = makeEvenGrid(scene, objects, threads)) != nullptr) {
        reason += " that lie evenly";
    } else if (isEmbreeInstalled()) {
        fastest = makeEmbreeAccelerator(scene, objects, threads);
    } else {
        fastest = makeGridAccelerator(scene, objects, threads);
        reason += ", as Embree is not installed";
    }
    fastest->reason = reason;
    return fastest;
}

std::span<const core::Word> acceleratorNames() {
    static const auto names = [] {
        std::array<core::Word, rows.size()> names;
        std::transform(rows.begin(), rows.end(), names.begin(), [](const Row& row) { return row.name; });
        return names;
    }();
    return names;
}

std::unique_ptr<Accelerator> makeAccelerator(core::Word name, const Scene& scene, int threads, bool manyRays) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
    if (manyRays) return row->make(scene, scene.bodies, threads, true);
    std::vector<std::uint32_t> objects = allOf(scene), endless;
    const auto hasEnd = [&](std::uint32_t i) { return !isEndless(scene.instances[i].shape); };
    const auto firstEndless = std::stable_partition(objects.begin(), objects.end(), hasEnd);
    endless.assign(firstEndless, objects.end());
    if (endless.empty() || row->name == "off") return row->make(scene, allOf(scene), threads, false);
    objects.erase(firstEndless, objects.end());
    return std::make_unique<WithEndless>(scene, endless, row->make(scene, objects, threads, false));
}

}  // namespace gr
