#include "gr/database/node.h"

namespace gr {

std::string Node::path() const {
    if (parent == nullptr) return ":";
    std::size_t length = 0;
    for (const Node* node = this; node->parent != nullptr; node = node->parent) length += node->name.size() + 1;
    std::string path(length, ':');
    for (const Node* node = this; node->parent != nullptr; node = node->parent) {
        length -= node->name.size();
        path.replace(length--, node->name.size(), node->name);
    }
    return path;
}

const Node* nextInSubtree(const Node* node, const Node* top) {
    if (node->firstChild != nullptr) return node->firstChild;
    while (node != top && node->next == nullptr) node = node->parent;
    return node == top ? nullptr : node->next;
}

}  // namespace gr
