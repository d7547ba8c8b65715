#include "core/memory.h"
#include "gr/contacts.h"
#include "gr/csg/csg_builder.h"
#include "gr/database/database.h"
#include "gr/database/object_count.h"
#include "gr/far_places.h"
#include "gr/flush.h"
#include "gr/many_rays.h"
#include "gr/near_origin.h"
#include "gr/placing.h"
#include "gr/scene.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <unordered_set>

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

// Whether a node shows nothing but what it holds.
bool isInner(const NodeContent& content) {
    return std::holds_alternative<TransformNode>(content) || operationOf(content);
}

class Compiler {
public:
    // Of the materials, used or not: where none is transparent nobody asks for flat objects, where none has a texture
    // not for nodes' own spaces.
    struct Asked {
        bool hasInteriors, hasTextures;
    };
    Compiler(const ObjectCounts& objects, const Asked& asked) : objects_(objects), asked_(asked) {}

    // origin: what of the world becomes the scene's own.
    Scene compile(const Node& top, const glm::dvec3& origin) {
        scene_.origin = origin;
        scene_.instances.reserve(static_cast<std::size_t>(objects_.at(&top)));
        open_.push_back({&top, glm::translate(glm::dmat4(1), -origin), nullptr, false, CsgTree::none});
        while (!open_.empty()) {
            const Visit visit = open_.back();
            open_.pop_back();
            expand(visit);
        }
        return std::move(scene_);
    }
    // Of what was compiled: the lamps,
    std::span<const Lamp> lamps() const { return lamps_; }
    // what may have gaps too narrow for single precision,
    std::span<const FlatObject> flatObjects() const { return flat_; }
    // and what stands too far away for it.
    const FarPlaces& farPlaces() const { return far_; }

private:
    // A node still to be looked at, with what comes from above. No node: that the CSG object is complete.
    struct Visit {
        const Node* node;
        glm::dmat4 parentMatrix;
        const NamedMaterial* parentMaterial;
        bool withSiblings;  // whether the siblings after it follow
        std::uint32_t csgParent;  // the node of the CSG object's tree that it is a child of, or none
    };

    void expand(const Visit& visit) {
        if (visit.node == nullptr) return addCsg();
        const Node& node = *visit.node;
        const glm::dmat4 matrix = node.matrix ? visit.parentMatrix * *node.matrix : visit.parentMatrix;
        const NamedMaterial* material = node.material != nullptr ? node.material : visit.parentMaterial;
        // What is pushed last comes next: children before siblings, in the order they were made.
        if (visit.withSiblings && node.next != nullptr)
            open_.push_back({node.next, visit.parentMatrix, visit.parentMaterial, true, visit.csgParent});
        const std::uint32_t csg = csgNode(node, visit.csgParent);
        if (node.firstChild != nullptr) open_.push_back({node.firstChild, matrix, material, true, csg});
        if (const auto* instance = std::get_if<InstanceNode>(&node.content)) {
            // Instances of nothing could take for ever.
            if (objects_.at(instance->target) > 0) open_.push_back({instance->target, matrix, material, false, csg});
        } else if (!isInner(node.content)) {
            const glm::dmat4 place =
                std::visit([&](const auto& content) { return add(content, matrix); }, node.content);
            if (csg != CsgTree::none) csg_.addOperand(node, csg);
            finish(node, material, place);
            if (asked_.hasTextures) scene_.nodeSpaces.emplace_back(glm::inverse(matrix) * place);
        }
    }

    // The node of a CSG object's tree whose children the node's are, and itself, or none. Whatever may be several
    // solids, or nothing, is the union of them.
    std::uint32_t csgNode(const Node& node, std::uint32_t parent) {
        const std::optional<CsgOperation> operation = operationOf(node.content);
        if (operation && parent == CsgTree::none) {
            csg_.begin(node);
            open_.push_back({});
        } else if (parent == CsgTree::none || isOne(node)) {
            return parent;
        }
        return csg_.addNode(parent, operation.value_or(CsgOperation::isUnion));
    }
    bool isOne(const Node& node) const {
        if (const auto* instance = std::get_if<InstanceNode>(&node.content))
            return node.firstChild == nullptr && objects_.at(instance->target) > 0;
        return node.firstChild == nullptr && !isInner(node.content);
    }

    // Its operands are the newest instances.
    void addCsg() {
        std::unique_ptr<Csg> csg = csg_.finish([&](std::uint32_t material) { return nameOf(material); });
        if (csg == nullptr) return;
        addInstance(csg.get(), glm::dmat4(1));
        scene_.instances.back().material = csg_.materialInside();
        if (asked_.hasTextures) scene_.nodeSpaces.emplace_back();
        scene_.csgs.push_back(std::move(csg));
    }
    std::string nameOf(std::uint32_t material) const {
        for (const auto& [named, index] : materialIndex_)
            if (index == material && named != nullptr) return "\"" + named->name + "\"";
        return "none";
    }

    // Each adds an instance and returns its place.
    glm::dmat4 add(const TransformNode&, const glm::dmat4& matrix) { return matrix; }
    glm::dmat4 add(const InstanceNode&, const glm::dmat4& matrix) { return matrix; }
    template<IsCsgNode Node>
    glm::dmat4 add(const Node&, const glm::dmat4& matrix) {
        return matrix;
    }
    template<CompleteShapeNode Node>
    glm::dmat4 add(const Node& node, const glm::dmat4& matrix) {
        return addInstance(node.shape(), node.placeIn(matrix));
    }
    glm::dmat4 add(const PolyhedronNode& node, const glm::dmat4& matrix) {
        if (polyhedra_.insert(node.polyhedron.get()).second) scene_.polyhedra.push_back(node.polyhedron);
        return addInstance(node.polyhedron.get(), glm::translate(matrix, node.polyhedron->origin()));
    }
    glm::dmat4 add(const AreaLightNode& light, const glm::dmat4& matrix) {
        const glm::dmat4 place = glm::scale(glm::translate(matrix, light.centre), glm::dvec3(light.size));
        const auto number = static_cast<std::uint32_t>(scene_.lights.of<AreaLight>().size());
        addInstance(Square{number}, place);
        scene_.lights.of<AreaLight>().push_back(lampAt(place, light.radiance, scene_.instances.back()));
        lamps_.push_back({static_cast<std::uint32_t>(scene_.instances.size() - 1), place});
        return place;
    }
    glm::dmat4 addInstance(Shape shape, const glm::dmat4& matrix) {
        Instance& instance = scene_.instances.emplace_back();
        instance.shape = shape;
        placeAt(instance, matrix, scene_);
        return matrix;
    }

    // Gives the newest instance its material, and checks that single precision can hold it.
    void finish(const Node& node, const NamedMaterial* material, const glm::dmat4& place) {
        Instance& instance = scene_.instances.back();
        for (const core::Transform& map : {instance.place.worldFromObject(), instance.place.objectFromWorld()})
            for (const core::Vec3f& column : {map.x, map.y, map.z, map.translation})
                if (!core::isFinite(column) || core::largestComponent(column) > 1e18f)
                    throw core::Error("SCENE", "RANGE", node.path(),
                                      "\"" + node.path() + "\" is too large, too small or too far away to be rendered");
        const auto [entry, isNew] = materialIndex_.try_emplace(material, scene_.materials.size());
        if (isNew) addMaterial(material != nullptr ? material->material : materials::Material{});
        instance.material = entry->second;
        far_.note(node, instance.shape, place);
        if (asked_.hasInteriors && flat_.size() < mostFlatObjects && hasFlatSides(instance.shape) &&
            !instance.isInverted)
            flat_.push_back({static_cast<std::uint32_t>(scene_.instances.size() - 1), place, &node,
                             instance.isOperand ? csg_.count() : ofNoCsg});
    }

    void addMaterial(const materials::Material& material) {
        scene_.materials.push_back(material);
        scene_.interiors.push_back(std::visit([](const auto& m) { return m.interior(); }, material));
        if (asked_.hasTextures) scene_.textures.push_back(materials::textureUses(material));
    }

    const ObjectCounts& objects_;
    const Asked asked_;
    Scene scene_;
    std::vector<Lamp> lamps_;
    std::vector<FlatObject> flat_;
    FarPlaces far_;
    std::vector<Visit> open_;
    std::unordered_map<const NamedMaterial*, std::uint32_t> materialIndex_;
    std::unordered_set<const Polyhedron*> polyhedra_;
    CsgBuilder csg_{scene_};
};

constexpr std::size_t mostWarnings = 8;

// Origin::isNear.
glm::dvec3 originFor(const std::vector<core::Bounds>& boxes, const Scene& scene) {
    core::Bounds all;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (!isEndless(scene.instances[i].shape) && !scene.instances[i].isOperand) all.include(boxes[i]);
    return all.isEmpty() ? glm::dvec3(0) : nearOrigin(glm::dvec3(all.low), glm::dvec3(all.high));
}

std::vector<core::Bounds> boundsOf(const Scene& scene) {
    std::vector<core::Bounds> boxes(scene.instances.size());
    std::transform(scene.instances.begin(), scene.instances.end(), boxes.begin(),
                   [](const Instance& instance) { return instance.bounds(); });
    return boxes;
}

}  // namespace

Scene compile(const Database& database, std::string_view path, std::span<const std::string> lights, Origin where,
              const Sky& sky) {
    const Node& top = database.find(path);
    std::vector<NamedLight> named;
    for (const std::string& name : lights) named.push_back(database.light(name));
    const ObjectCounts objects = countObjects(top);
    checkMemory(top, objects.at(&top));
    const Compiler::Asked asked{database.hasInteriors(), database.hasTextures()};
    std::optional<Compiler> compiler(std::in_place, objects, asked);
    Scene scene = compiler->compile(top, glm::dvec3(0));
    std::vector<core::Bounds> boxes = boundsOf(scene);
    const glm::dvec3 origin = where == Origin::isNear ? originFor(boxes, scene) : glm::dvec3(0);
    if (origin != glm::dvec3(0)) {
        scene = compiler.emplace(objects, asked).compile(top, origin);
        boxes = boundsOf(scene);
    }
    if (const std::string warning = compiler->farPlaces().warning(scene.origin); !warning.empty())
        scene.warnings.push_back(warning);
    const std::vector<Contact> contacts = contactsOf(scene, compiler->flatObjects(), boxes);
    for (const Contact& contact : contacts)
        if (const std::string warning = contact.warning(); !warning.empty() && scene.warnings.size() < mostWarnings)
            scene.warnings.push_back(warning);
    const std::vector<float> grown = growTouching(scene, contacts, boxes);
    liftLamps(scene, compiler->lamps(), grown, boxes);
    for (const NamedLight& light : named)
        std::visit(
            [&]<class Kind>(Kind one) {
                if constexpr (!Kind::isEndless) one.moveBy(core::Vec3f(-scene.origin));
                scene.lights.of<Kind>().push_back(one);
            },
            light);
    if (sky.grid != nullptr) {
        const double turns = sky.degrees / 360;
        scene.sky = sky.grid;
        scene.lights.of<SkyLight>() = {
            {scene.sky.get(), scene.sky->unit(), static_cast<float>(turns - std::floor(turns))}};
    }
    finishCsgs(scene, boxes);
    sortForManyRays(scene, boxes);
    return scene;
}

}  // namespace gr
