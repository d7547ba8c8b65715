// The scene that a script builds: a tree of nodes, materials and lights by name.
// Every function throws core::Error with a message that names the word that is wrong, and then has changed nothing.
#pragma once

#include "core/error.h"
#include "gr/database/node.h"
#include "gr/light.h"
#include "gr/mesh/mesh_file.h"

#include <array>
#include <unordered_map>
#include <unordered_set>

namespace gr {

// What a database holds.
struct DatabaseStatistics {
    // Nodes of each kind, as NodeContent lists them; the root is none of them.
    std::array<std::size_t, std::variant_size_v<NodeContent>> nodes{};
    double objects = 0;  // of the whole tree once its instances are spread out; see object_count.h
    // A mesh that several nodes show is one.
    std::size_t meshes = 0, triangles = 0;
    std::size_t materials = 0, lights = 0;
    // Memory that is allocated: for the nodes, their names and matrices, and the tables that find them; for the meshes;
    // for materials and the lights that have names.
    std::size_t nodeBytes = 0, meshBytes = 0, materialBytes = 0;
};

class Database {
public:
    Database();
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    // Makes a node and returns it. parent: full path. The name #auto becomes kind and a number, sphere1 or sphere2,
    // the next that is free there. kind: text that stays.
    Node& create(std::string_view parent, std::string_view name, NodeContent content, std::string_view kind = "node");
    Node& createInstance(std::string_view parent, std::string_view name, std::string_view target);

    // Each post-multiplies the node's matrix: the last one acts first on the geometry.
    void translate(std::string_view node, const glm::dvec3& by);
    // About the axis x (0), y (1) or z (2), or any other through the origin, of any length but 0: counter-clockwise
    // seen from its tip. Quarter turns are exact.
    void rotate(std::string_view node, int axis, double degrees);
    void rotate(std::string_view node, const glm::dvec3& axis, double degrees);
    void scale(std::string_view node, const glm::dvec3& about, const glm::dvec3& by);
    // matrix: invertible, its last row 0 0 0 1.
    void multiply(std::string_view node, const glm::dmat4& matrix);
    // Moves the node's origin to eye and turns its -z axis to target, its y axis as near to up as that leaves it.
    // None of the two directions is 0, and they are not parallel.
    void lookAt(std::string_view node, const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);
    void forgetTransforms(std::string_view node);

    // Both return the name: of #auto material1, light1 or sun1, the next that is free. words: what the script says of
    // the material; one that was made by the same words stays.
    std::string addMaterial(std::string_view name, const materials::Material& material, std::string_view words = {});
    // kind: light or sun, text that stays: what #auto counts.
    std::string addLight(std::string_view name, const NamedLight& light, std::string_view kind = "light");
    // One that was made by the same words stays.
    std::string addTexture(std::string_view name, std::shared_ptr<const materials::Texture> texture,
                           std::string_view words);
    // null where there is none
    std::shared_ptr<const materials::Texture> findTexture(std::string_view name) const;
    // Throws where addTexture would, for whoever has much to do before; whether one made by these words is there.
    bool checkNewTexture(std::string_view name, std::string_view words) const;
    std::vector<std::string_view> textureNames() const;  // in the alphabet's order
    // The nodes that have the material, and the renders that name the light, get this one.
    void redefineMaterial(std::string_view name, const materials::Material& material, std::string_view words = {});
    void redefineLight(std::string_view name, const NamedLight& light);
    // Throws where a node has the material.
    void removeMaterial(std::string_view name);
    void removeLight(std::string_view name);
    void setMaterial(std::string_view node, std::string_view material);

    void remove(std::string_view node);
    void reset();
    // The subtree as indented text, a node a line; behind the whole tree the lights that have names, a light a line.
    std::string print(std::string_view node) const;

    const Node& find(std::string_view path) const;
    const NamedLight& light(std::string_view name) const;
    std::vector<std::string> lightNames() const;  // in the alphabet's order
    bool hasInteriors() const;  // whether one of its materials has something inside of it
    bool hasTextures() const;  // whether one of its materials has a texture
    // Throws unless a node of that name may be made there.
    void checkNew(std::string_view parent, std::string_view name) const;
    // The polyhedron in a mesh file; see MeshFiles.
    std::shared_ptr<const Polyhedron> readMesh(const std::string& path, std::string_view name, MeshRepairs& repairs,
                                               const core::Folder* below = nullptr, const MeshSettings& settings = {}) {
        return meshFiles_.read(path, name, repairs, below, settings);
    }
    std::size_t nodeCount() const { return index_.size() + 1; }
    // Takes time in proportion to the number of nodes.
    DatabaseStatistics statistics() const;

private:
    // A node is found by its parent and its name.
    struct Key {
        const Node* parent;
        std::string_view name;
        bool operator==(const Key&) const = default;
    };
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(const Key& key) const;
        std::size_t operator()(const std::unique_ptr<Node>& node) const {
            return (*this)(Key{node->parent, node->name});
        }
    };
    struct Equal {
        using is_transparent = void;
        static Key key(const Key& key) { return key; }
        static Key key(const std::unique_ptr<Node>& node) { return {node->parent, node->name}; }
        bool operator()(const auto& a, const auto& b) const { return key(a) == key(b); }
    };

    using AutoNumbers = std::unordered_map<std::string_view, std::size_t>;

    const Node* child(const Node& parent, std::string_view name) const;
    Node& get(std::string_view path);
    [[noreturn]] void throwUnknownNode(std::string_view path) const;
    void checkNoCycle(const Node& parent, const Node& target) const;
    // Throws when an instance that is not in `except` stands for the node.
    void checkNotInstanced(const Node& node, const std::unordered_set<const Node*>& except) const;
    void erase(const Node& node);
    std::string namedLightsText() const;
    NamedMaterial& namedMaterial(std::string_view name);
    NamedLight& namedLight(std::string_view name);

    Node root_;
    std::unordered_set<std::unique_ptr<Node>, Hash, Equal> index_;
    std::unordered_map<const Node*, std::unordered_set<const Node*>> instancesOf_;
    std::unordered_map<std::string, NamedMaterial> materials_;
    struct NamedTexture {
        std::shared_ptr<const materials::Texture> texture;
        std::string words;  // what the script says of it
    };
    std::unordered_map<std::string, NamedTexture> textures_;
    std::unordered_map<std::string, NamedLight> lights_;
    // The last number that #auto gave: to children of a node by what they are, to materials, to lights by their kind.
    std::unordered_map<const Node*, AutoNumbers> autoNumbers_;
    std::size_t lastMaterial_ = 0, lastTexture_ = 0;
    AutoNumbers lastLights_;
    MeshFiles meshFiles_;
};

}  // namespace gr
