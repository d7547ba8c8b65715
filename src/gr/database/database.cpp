#include "gr/database/database.h"
#include "gr/database/auto_name.h"

#include <algorithm>
#include <cctype>

namespace gr {
namespace {

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

Node& Database::create(std::string_view parentPath, std::string_view name, NodeContent content, std::string_view kind) {
    checkNew(parentPath, name);
    Node& parent = get(parentPath);
    auto made = std::make_unique<Node>();
    Node& node = *made;
    std::size_t* lastNumber = nullptr;
    AutoName free;
    if (name == autoName) {
        lastNumber = &autoNumbers_[&parent][kind];
        free = nextFree(kind, *lastNumber, [&](const std::string& word) { return child(parent, word) != nullptr; });
    }
    node.name = lastNumber != nullptr ? std::string_view(free.name) : name;
    node.content = std::move(content);
    node.parent = &parent;
    index_.insert(std::move(made));
    if (lastNumber != nullptr) *lastNumber = free.number;
    node.previous = parent.lastChild;
    (parent.lastChild != nullptr ? parent.lastChild->next : parent.firstChild) = &node;
    parent.lastChild = &node;
    return node;
}

Node& Database::createInstance(std::string_view parent, std::string_view name, std::string_view targetPath) {
    checkNew(parent, name);
    const Node& target = find(targetPath);
    checkNoCycle(find(parent), target);
    Node& node = create(parent, name, InstanceNode{&target}, InstanceNode::kind);
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
    autoNumbers_.erase(&node);
    if (node.material != nullptr) --node.material->users;
    index_.erase(index_.find(Key{node.parent, node.name}));
}

void Database::reset() {
    instancesOf_.clear();
    index_.clear();
    root_ = Node{};
    materials_.clear();
    textures_.clear();
    lights_.clear();
    autoNumbers_.clear();
    lastMaterial_ = lastTexture_ = 0;
    lastLights_.clear();
}

}  // namespace gr
