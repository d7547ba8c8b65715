#include "gr/database/object_count.h"

#include <vector>

namespace gr {

ObjectCounts countObjects(const Node& top) {
    ObjectCounts known;
    std::vector<const Node*> open{&top};
    while (!open.empty()) {
        const Node* subtree = open.back();
        if (known.contains(subtree)) {
            open.pop_back();
            continue;
        }
        double sum = 0;
        bool complete = true;
        for (const Node* node = subtree; node != nullptr; node = nextInSubtree(node, subtree)) {
            const auto* instance = std::get_if<InstanceNode>(&node->content);
            if (instance == nullptr) {
                // Of a CSG object that is one beside its operands.
                sum += !std::holds_alternative<TransformNode>(node->content);
                continue;
            }
            const auto target = known.find(instance->target);
            if (target != known.end()) {
                sum += target->second;
            } else {
                open.push_back(instance->target);
                complete = false;
            }
        }
        if (!complete) continue;
        known[subtree] = sum;
        open.pop_back();
    }
    return known;
}

}  // namespace gr
