#include "core/memory.h"
#include "gr/database/database.h"
#include "gr/database/object_count.h"
#include "gr/scene.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <numeric>

namespace gr {
namespace {

void checkMemory(const Node& top, double objects) {
    // How many are turned, and need whole maps, is known only when they are spread out.
    const double needed = objects * (sizeof(Instance) + sizeof(Placement::General));
    const double available = static_cast<double>(core::availableMemory());
    if (needed > available)
        throw core::Error("SCENE", "MEMORY", top.path(),
                          "\"" + top.path() + "\" has " + core::numberText(objects) +
                              " objects when its instances are spread out, which takes " + core::memoryText(needed) +
                              " of memory; " + core::memoryText(available) + " are free");
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

glm::dmat3 absolute(const glm::dmat4& matrix) {
    return {glm::abs(glm::dvec3(matrix[0])), glm::abs(glm::dvec3(matrix[1])), glm::abs(glm::dvec3(matrix[2]))};
}

// The largest absolute coordinates of any point of a shape, along each of its own axes; of one that is endless 0.
glm::dvec3 extentOf(const Shape& shape) {
    const auto extent = [](const core::Bounds& bounds) {
        return glm::dvec3(glm::max(glm::abs(bounds.low), glm::abs(bounds.high)));
    };
    const auto visit = [&]<class S>(const S& s) {
        if constexpr (std::is_pointer_v<S>)
            return extent(s->bounds());
        else
            return S::isEndless ? glm::dvec3(0) : extent(s.bounds());
    };
    return std::visit(visit, shape);
}

// What a placement makes of numbers that are each off by no more than so much, row by row, at the most:
struct Sizes {
    double extent = 0;  // |worldFromObject| |the shape's extent|
    double thereAndBack = 0;  // |worldFromObject| |objectFromWorld| |1|
    double extentThereAndBack = 0;  // |worldFromObject| |objectFromWorld| |worldFromObject| |the shape's extent|
    double backTranslation = 0;  // |worldFromObject| |objectFromWorld's translation|

    Sizes(const glm::dmat4& matrix, const glm::dmat4& inverse, const Shape& shape) {
        const glm::dmat3 there = absolute(matrix), back = absolute(inverse);
        const glm::dvec3 inWorld = there * extentOf(shape);
        extent = largest(inWorld);
        thereAndBack = largest(there * (back * glm::dvec3(1)));
        extentThereAndBack = largest(there * (back * inWorld));
        backTranslation = largest(there * glm::abs(glm::dvec3(inverse[3])));
    }
};

class Compiler {
public:
    explicit Compiler(const ObjectCounts& objects) : objects_(objects) {}

    Scene compile(const Node& top) {
        scene_.instances.reserve(static_cast<std::size_t>(objects_.at(&top)));
        open_.push_back({&top, glm::dmat4(1), nullptr, false});
        while (!open_.empty()) {
            const Visit visit = open_.back();
            open_.pop_back();
            expand(visit);
        }
        liftLamps();
        return std::move(scene_);
    }

private:
    // A node still to be looked at, with what comes from above.
    struct Visit {
        const Node* node;
        glm::dmat4 parentMatrix;
        const NamedMaterial* parentMaterial;
        bool withSiblings;  // whether the siblings after it follow
    };

    void expand(const Visit& visit) {
        const Node& node = *visit.node;
        const glm::dmat4 matrix = node.matrix ? visit.parentMatrix * *node.matrix : visit.parentMatrix;
        const NamedMaterial* material = node.material != nullptr ? node.material : visit.parentMaterial;
        // What is pushed last comes next: children before siblings, in the order they were made.
        if (visit.withSiblings && node.next != nullptr)
            open_.push_back({node.next, visit.parentMatrix, visit.parentMaterial, true});
        if (node.firstChild != nullptr) open_.push_back({node.firstChild, matrix, material, true});
        if (const auto* instance = std::get_if<InstanceNode>(&node.content)) {
            // Instances of nothing could take for ever.
            if (objects_.at(instance->target) > 0) open_.push_back({instance->target, matrix, material, false});
        } else if (!std::holds_alternative<TransformNode>(node.content)) {
            std::visit([&](const auto& content) { add(content, matrix); }, node.content);
            finish(node, material);
        }
    }

    void add(const TransformNode&, const glm::dmat4&) {}
    void add(const InstanceNode&, const glm::dmat4&) {}
    template<CompleteShapeNode Node>
    void add(const Node& node, const glm::dmat4& matrix) {
        addInstance(node.shape(), node.placeIn(matrix));
    }
    void add(const PolyhedronNode& node, const glm::dmat4& matrix) {
        if (polyhedra_.insert(node.polyhedron.get()).second) scene_.polyhedra.push_back(node.polyhedron);
        addInstance(node.polyhedron.get(), matrix);
    }
    void add(const AreaLightNode& light, const glm::dmat4& matrix) {
        const glm::dmat4 place = glm::scale(glm::translate(matrix, light.centre), glm::dvec3(light.size));
        const auto number = static_cast<std::uint32_t>(scene_.lights.of<AreaLight>().size());
        addInstance(Square{number}, place);
        scene_.lights.of<AreaLight>().push_back(lampAt(place, light.radiance, scene_.instances.back()));
        lamps_.push_back({scene_.instances.size() - 1, place});
    }

    // A plane's normal goes by the transposed inverse, which keeps it on the same side of the plane.
    static glm::dvec3 normalOf(const glm::dmat4& place) {
        return glm::normalize(glm::transpose(glm::inverse(glm::dmat3(place))) * glm::dvec3(0, -1, 0));
    }

    static AreaLight lampAt(const glm::dmat4& place, const core::Rgbf& radiance, const Instance& instance) {
        const core::Vec3f edge1(place[0]), edge2(place[2]);
        const core::Vec3f corner(place * glm::dvec4(-0.5, 0, -0.5, 1));
        const float area = static_cast<float>(glm::length(glm::cross(glm::dvec3(place[0]), glm::dvec3(place[2]))));
        const float size =
            core::largestComponent(corner) + core::largestComponent(edge1) + core::largestComponent(edge2);
        return {corner,
                edge1,
                edge2,
                core::Vec3f(normalOf(place)),
                radiance,
                area,
                instance.error + instance.errorPerUnit() * size,
                instance.errorPerUnit()};
    }

    // A lamp in the very plane of a ceiling, or two lamps back to back: which of them a ray meets would be up to
    // rounding. So a lamp that touches something is lifted off it, to the side to which it shines, by more than
    // rounding moves the place where rays meet either: 2^-24 of the coordinates on the way there, a few times over.
    void liftLamps() {
        if (lamps_.empty()) return;
        std::vector<core::Bounds> boxes;
        std::vector<std::uint32_t> farthest, endless;
        for (std::uint32_t i = 0; i < scene_.instances.size(); ++i) {
            boxes.push_back(scene_.instances[i].bounds());
            (isEndless(scene_.instances[i].shape) ? endless : farthest).push_back(i);
        }
        const auto middle = farthest.begin() + static_cast<std::ptrdiff_t>(std::min(farthest.size(), mostLookedAt));
        const auto isFarther = [&](std::uint32_t a, std::uint32_t b) {
            return boxes[a].reach() != boxes[b].reach() ? boxes[a].reach() > boxes[b].reach() : a < b;
        };
        std::partial_sort(farthest.begin(), middle, farthest.end(), isFarther);
        for (std::size_t i = 0; i < lamps_.size(); ++i) {
            const Lamp& lamp = lamps_[i];
            float reach = reachOfTouching(lamp.instance, boxes, farthest);
            // Of what has no end the part that is as far away as the lamp counts.
            const auto isTouching = [&](std::uint32_t other) { return touch(boxes[other], boxes[lamp.instance]); };
            if (std::any_of(endless.begin(), endless.end(), isTouching))
                reach = std::max(reach, boxes[lamp.instance].reach());
            if (reach == 0) continue;
            const glm::dmat4 place =
                glm::translate(glm::dmat4(1), normalOf(lamp.place) * (0x1p-19 * reach)) * lamp.place;
            Instance& instance = scene_.instances[lamp.instance];
            const glm::dmat4 inverse = glm::inverse(place);
            const Sizes sizes(place, inverse, instance.shape);
            instance.place = placementOf(place, inverse, sizes);
            instance.error = errorOf(place, sizes);
            AreaLight& light = scene_.lights.of<AreaLight>()[i];
            light = lampAt(place, light.radiance, instance);
        }
    }

    static bool touch(const core::Bounds& a, const core::Bounds& b) { return !a.intersection(b).isEmpty(); }

    // The largest coordinate of what a lamp touches, or 0. Of many objects only those that reach farthest are looked
    // at; none of the others reaches farther than the last of those.
    static float reachOfTouching(std::size_t lamp, const std::vector<core::Bounds>& boxes,
                                 const std::vector<std::uint32_t>& farthest) {
        const std::size_t count = std::min(farthest.size(), mostLookedAt);
        for (std::size_t i = 0; i < count; ++i)
            if (farthest[i] != lamp && touch(boxes[farthest[i]], boxes[lamp]))
                return std::max(boxes[farthest[i]].reach(), boxes[lamp].reach());
        return count == farthest.size() ? 0 : boxes[farthest[count - 1]].reach();
    }

    void addInstance(Shape shape, const glm::dmat4& matrix) {
        const glm::dmat4 inverse = glm::inverse(matrix);
        const Sizes sizes(matrix, inverse, shape);
        scene_.instances.push_back({placementOf(matrix, inverse, sizes), shape, 0, errorOf(matrix, sizes)});
    }

    Placement placementOf(const glm::dmat4& matrix, const glm::dmat4& inverse, const Sizes& sizes) {
        const core::Transform there(matrix), back(inverse);
        if (matrix == glm::dmat4(1)) return {};
        const auto isAligned = [](const core::Transform& m) {
            return m.x.y == 0 && m.x.z == 0 && m.y.x == 0 && m.y.z == 0 && m.z.x == 0 && m.z.y == 0;
        };
        const auto aligned = [](const core::Transform& m) -> AlignedMap {
            return {{{m.x.x, m.y.y, m.z.z}, m.translation}};
        };
        if (isAligned(there) && isAligned(back)) return Placement::Aligned{aligned(there), aligned(back)};
        scene_.placements.push_back(std::make_unique<Placement::General>(
            Placement::General{there, back, static_cast<float>(sizes.thereAndBack)}));
        return Placement(scene_.placements.back().get());
    }

    // How far roundings may move a point along an axis on its way from the object to the world and back, in units of
    // u = 2^-24, the relative size of one. |x| is the point's largest coordinate, extent and the like are what Sizes
    // has: each axis of the object counts by how far the shape reaches along it and by what the matrix makes of that.
    // What is short but stretched and what is long but not are then as large as they are in the world.
    // A row times a vector makes 4: the entries, the products and two sums.
    //   6 extent                                  where the shape computes it
    //   4 extent + |translation| + |x|            in worldFromObject
    //   |x|                                       in the step off the surface
    //   4 thereAndBack |x| + |back translation| + extent    in objectFromWorld
    //   17 extent                                 in the next intersection: a triangle's corners, seen along the ray
    // and for a ray along the surface, which goes on for up to twice the extent,
    //   2 * 10 extent                             in its direction, out of the frame round the normal
    //   2 * (4 + 4) extentThereAndBack            in its direction in the object, and in the normal in the world
    // Instance::errorPerUnit is twice what this asks for, since a shadow ray also rounds by how far away it starts.
    static float errorOf(const glm::dmat4& matrix, const Sizes& sizes) {
        constexpr double u = 0x1p-24;
        return static_cast<float>(u * (48 * sizes.extent + 16 * sizes.extentThereAndBack +
                                       largest(glm::dvec3(matrix[3])) + sizes.backTranslation));
    }

    // Gives the newest instance its material, and checks that single precision can hold it.
    void finish(const Node& node, const NamedMaterial* material) {
        Instance& instance = scene_.instances.back();
        for (const core::Transform& map : {instance.place.worldFromObject(), instance.place.objectFromWorld()})
            for (const core::Vec3f& column : {map.x, map.y, map.z, map.translation})
                if (!core::isFinite(column) || core::largestComponent(column) > 1e18f)
                    throw core::Error("SCENE", "RANGE", node.path(),
                                      "\"" + node.path() + "\" is too large, too small or too far away to be rendered");
        const auto [entry, isNew] = materialIndex_.try_emplace(material, scene_.materials.size());
        if (isNew) addMaterial(material != nullptr ? material->material : materials::Material{});
        instance.material = entry->second;
    }

    void addMaterial(const materials::Material& material) {
        scene_.materials.push_back(material);
        scene_.interiors.push_back(std::visit([](const auto& m) { return m.interior(); }, material));
    }

    struct Lamp {
        std::size_t instance;
        glm::dmat4 place;
    };
    static constexpr std::size_t mostLookedAt = 64;

    const ObjectCounts& objects_;
    Scene scene_;
    std::vector<Lamp> lamps_;
    std::vector<Visit> open_;
    std::unordered_map<const NamedMaterial*, std::uint32_t> materialIndex_;
    std::unordered_set<const Polyhedron*> polyhedra_;
};

// Half of a box's surface.
double surface(const core::Bounds& box) {
    const glm::dvec3 size = box.size();
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

// Takes the object with the largest box out of `bodies`, if it is a fair part of the box round all: in a tree nearly
// every ray would have to be tested against it, too, but one by one. boxes: of the bodies. Returns whether it did.
bool takeLargest(Scene& scene, std::vector<core::Bounds>& boxes) {
    constexpr double fairPart = 0.125;
    core::Bounds all;
    double most = 0;
    std::size_t largest = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        all.include(boxes[i]);
        const bool isMesh = scene.instances[scene.bodies[i]].shape.index() == 0;
        if (isMesh || surface(boxes[i]) <= most) continue;
        most = surface(boxes[i]);
        largest = i;
    }
    if (most == 0 || most < fairPart * surface(all)) return false;
    scene.large.push_back(scene.bodies[largest]);
    scene.bodies.erase(scene.bodies.begin() + static_cast<std::ptrdiff_t>(largest));
    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(largest));
    return true;
}

void sortForManyRays(Scene& scene) {
    constexpr std::size_t mostLarge = 12;
    scene.faces = facesOf(scene);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        if (isEndless(scene.instances[i].shape))
            scene.large.push_back(i);
        else if (scene.faces.isFlat.empty() || !scene.faces.isFlat[i])
            scene.bodies.push_back(i);
    }
    std::vector<core::Bounds> boxes(scene.bodies.size());
    std::transform(scene.bodies.begin(), scene.bodies.end(), boxes.begin(),
                   [&](std::uint32_t i) { return scene.instances[i].bounds(); });
    for (std::size_t taken = 0; taken < mostLarge && takeLargest(scene, boxes);) ++taken;
    std::sort(scene.large.begin(), scene.large.end());
}

}  // namespace

Scene compile(const Database& database, std::string_view path, std::span<const std::string> lights) {
    const Node& top = database.find(path);
    std::vector<NamedLight> named;
    for (const std::string& name : lights) named.push_back(database.light(name));
    const ObjectCounts objects = countObjects(top);
    checkMemory(top, objects.at(&top));
    Scene scene = Compiler(objects).compile(top);
    for (const NamedLight& light : named)
        std::visit([&]<class Kind>(const Kind& one) { scene.lights.of<Kind>().push_back(one); }, light);
    sortForManyRays(scene);
    return scene;
}

}  // namespace gr
