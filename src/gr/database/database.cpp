#include "gr/database/database.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cctype>

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

void checkName(std::string_view name) {
    const auto isBad = [](unsigned char c) { return c == ':' || std::isspace(c) || c == '\0'; };
    if (name.empty()) throw core::Error("NODE", "NAME", "", "a name must not be empty");
    if (std::any_of(name.begin(), name.end(), isBad))
        throw core::Error("NODE", "NAME", std::string(name),
                          "bad name \"" + std::string(name) + "\": a name holds neither \":\" nor white space");
}

}  // namespace

Database::Database() = default;
Database::~Database() = default;

std::size_t Database::Hash::operator()(const Key& key) const {
    const std::size_t parent = std::hash<const Node*>{}(key.parent);
    return std::hash<std::string_view>{}(key.name) ^ (parent * 0x9E3779B97F4A7C15);
}

const Node* Database::child(const Node& parent, std::string_view name) const {
    const auto found = index_.find(Key{&parent, name});
    return found == index_.end() ? nullptr : found->get();
}

const Node& Database::find(std::string_view path) const {
    if (path == ":") return root_;
    if (path.empty() || path[0] != ':') throwUnknownNode(path);
    const Node* node = &root_;
    for (std::size_t start = 1; start <= path.size() && node != nullptr;) {
        const std::size_t end = std::min(path.find(':', start), path.size());
        node = child(*node, path.substr(start, end - start));
        start = end + 1;
    }
    if (node == nullptr || path.back() == ':') throwUnknownNode(path);
    return *node;
}

Node& Database::get(std::string_view path) {
    return const_cast<Node&>(find(path));
}

void Database::throwUnknownNode(std::string_view given) const {
    // A path ends at its last word.
    std::string_view path = given;
    while (path.size() > 1 && path.ends_with(':')) path.remove_suffix(1);
    // Follow the path as far as it leads; what is meant is likely a sibling of the first word that is wrong.
    const Node* parent = &root_;
    std::size_t start = !path.empty() && path[0] == ':' ? 1 : 0;
    std::size_t end = std::min(path.find(':', start), path.size());
    while (end < path.size()) {
        const Node* next = child(*parent, path.substr(start, end - start));
        if (next == nullptr) break;
        parent = next;
        start = end + 1;
        end = std::min(path.find(':', start), path.size());
    }
    const std::string_view rest = end < path.size() ? path.substr(end) : "";
    std::string suggestion;
    std::vector<std::string_view> siblings;
    for (const Node* node = parent->firstChild; node != nullptr; node = node->next) siblings.push_back(node->name);
    const std::string near = core::nearest(path.substr(start, end - start), siblings);
    const std::string_view word = path.substr(start, end - start);
    const bool isThere = std::find(siblings.begin(), siblings.end(), word) != siblings.end();
    const std::string_view meant = isThere ? word : std::string_view(near);
    if (!meant.empty()) suggestion = child(*parent, meant)->path() + std::string(rest);
    std::string message = "no such node \"" + std::string(given) + "\"";
    if (!suggestion.empty()) message += " (did you mean \"" + suggestion + "\"?)";
    throw core::Error("NODE", "UNKNOWN", std::string(given), message);
}

void Database::checkNew(std::string_view parentPath, std::string_view name) const {
    const Node& parent = find(parentPath);
    checkName(name);
    const Node* existing = child(parent, name);
    if (existing != nullptr)
        throw core::Error("NODE", "EXISTS", existing->path(), "node \"" + existing->path() + "\" already exists");
}

Node& Database::create(std::string_view parentPath, std::string_view name, NodeContent content) {
    checkNew(parentPath, name);
    Node& parent = get(parentPath);
    auto made = std::make_unique<Node>();
    Node& node = *made;
    node.name = name;
    node.content = std::move(content);
    node.parent = &parent;
    index_.insert(std::move(made));
    node.previous = parent.lastChild;
    (parent.lastChild != nullptr ? parent.lastChild->next : parent.firstChild) = &node;
    parent.lastChild = &node;
    return node;
}

Node& Database::createInstance(std::string_view parent, std::string_view name, std::string_view targetPath) {
    checkNew(parent, name);
    const Node& target = find(targetPath);
    checkNoCycle(find(parent), target);
    Node& node = create(parent, name, InstanceNode{&target});
    instancesOf_[&target].insert(&node);
    return node;
}

void Database::checkNoCycle(const Node& parent, const Node& target) const {
    // An instance of the target inside the target would hold itself. What holds the parent: its ancestors, and the
    // instances of each of them with their ancestors in turn.
    std::unordered_set<const Node*> seen;
    std::vector<const Node*> open{&parent};
    while (!open.empty()) {
        const Node* node = open.back();
        open.pop_back();
        for (; node != nullptr && seen.insert(node).second; node = node->parent) {
            if (node == &target)
                throw core::Error(
                    "NODE", "CYCLE", target.path(),
                    "an instance of \"" + target.path() + "\" in \"" + parent.path() + "\" would hold itself");
            const auto instances = instancesOf_.find(node);
            if (instances != instancesOf_.end())
                open.insert(open.end(), instances->second.begin(), instances->second.end());
        }
    }
}

void Database::multiply(std::string_view path, const glm::dmat4& matrix) {
    Node& node = get(path);
    const glm::dmat4 product = node.matrix ? *node.matrix * matrix : matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            if (!std::isfinite(static_cast<float>(product[column][row])))
                throw core::Error("VALUE", "RANGE", node.path(),
                                  "the matrix of \"" + node.path() + "\" grows beyond numbers");
    if (!node.matrix) node.matrix = std::make_unique<glm::dmat4>();
    *node.matrix = product;
}

void Database::translate(std::string_view node, const glm::dvec3& by) {
    multiply(node, glm::translate(glm::dmat4(1), by));
}

void Database::rotate(std::string_view node, int axis, double degrees) {
    // Quarter turns are exact.
    const double turns = std::remainder(degrees, 360);
    const bool quarter = std::remainder(turns, 90) == 0;
    const double radians = glm::radians(turns);
    const double sine = quarter ? std::round(std::sin(radians)) : std::sin(radians);
    const double cosine = quarter ? std::round(std::cos(radians)) : std::cos(radians);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::dmat4 matrix(1);
    matrix[u][u] = matrix[v][v] = cosine;
    matrix[u][v] = sine;
    matrix[v][u] = -sine;
    multiply(node, matrix);
}

void Database::scale(std::string_view node, const glm::dvec3& about, const glm::dvec3& by) {
    multiply(node, glm::translate(glm::scale(glm::translate(glm::dmat4(1), about), by), -about));
}

void Database::addMaterial(std::string_view name, const materials::Material& material) {
    const std::string key(name);
    if (key.empty()) throw core::Error("MATERIAL", "NAME", "", "a name must not be empty");
    if (!materials_.try_emplace(key, NamedMaterial{key, material}).second)
        throw core::Error("MATERIAL", "EXISTS", key, "material \"" + key + "\" already exists");
}

void Database::setMaterial(std::string_view path, std::string_view name) {
    Node& node = get(path);
    const auto found = materials_.find(std::string(name));
    if (found == materials_.end())
        throw core::Error(
            "MATERIAL", "UNKNOWN", std::string(name),
            "no such material \"" + std::string(name) + "\"" + core::didYouMean(name, namesOf(materials_)));
    node.material = &found->second;
}

void Database::addLight(std::string_view name, const NamedLight& light) {
    const std::string key(name);
    if (key.empty()) throw core::Error("LIGHT", "NAME", "", "a name must not be empty");
    if (!lights_.try_emplace(key, light).second)
        throw core::Error("LIGHT", "EXISTS", key, "light \"" + key + "\" already exists");
}

bool Database::hasInteriors() const {
    return std::any_of(materials_.begin(), materials_.end(), [](const auto& entry) {
        return std::visit([](const auto& material) { return material.interior().has_value(); }, entry.second.material);
    });
}

const NamedLight& Database::light(std::string_view name) const {
    const auto found = lights_.find(std::string(name));
    if (found == lights_.end())
        throw core::Error("LIGHT", "UNKNOWN", std::string(name),
                          "no such light \"" + std::string(name) + "\"" + core::didYouMean(name, namesOf(lights_)));
    return found->second;
}

void Database::checkNotInstanced(const Node& node, const std::unordered_set<const Node*>& except) const {
    const auto instances = instancesOf_.find(&node);
    if (instances == instancesOf_.end()) return;
    // Of several users the first in the alphabet is named: a hash of addresses has no order that stays.
    std::string user;
    for (const Node* instance : instances->second) {
        if (except.contains(instance)) continue;
        const std::string candidate = instance->path();
        if (user.empty() || candidate < user) user = candidate;
    }
    if (!user.empty())
        throw core::Error("NODE", "INSTANCED", node.path(),
                          "\"" + node.path() + "\" is used by the instance \"" + user + "\"");
}

void Database::remove(std::string_view path) {
    Node& top = get(path);
    if (&top == &root_)
        throw core::Error("NODE", "ROOT", ":", "the root \":\" cannot be deleted; gr_reset deletes everything");
    std::unordered_set<const Node*> doomed;
    for (const Node* node = &top; node != nullptr; node = nextInSubtree(node, &top)) doomed.insert(node);
    for (const Node* node = &top; node != nullptr; node = nextInSubtree(node, &top)) checkNotInstanced(*node, doomed);
    (top.previous != nullptr ? top.previous->next : top.parent->firstChild) = top.next;
    (top.next != nullptr ? top.next->previous : top.parent->lastChild) = top.previous;
    for (const Node* node : doomed) erase(*node);
}

void Database::erase(const Node& node) {
    instancesOf_.erase(&node);
    if (const auto* instance = std::get_if<InstanceNode>(&node.content)) {
        const auto users = instancesOf_.find(instance->target);
        if (users != instancesOf_.end() && users->second.erase(&node) == 1 && users->second.empty())
            instancesOf_.erase(users);
    }
    index_.erase(index_.find(Key{node.parent, node.name}));
}

void Database::reset() {
    instancesOf_.clear();
    index_.clear();
    root_ = Node{};
    materials_.clear();
    lights_.clear();
}

}  // namespace gr
