// How many objects a scene has once its instances are replaced by what they stand for.
#pragma once

#include "gr/database/node.h"

#include <unordered_map>

namespace gr {

// Of each subtree. Doubles: nested instances double, and double again.
using ObjectCounts = std::unordered_map<const Node*, double>;

// Of top and of all that is instanced below it.
ObjectCounts countObjects(const Node& top);

}  // namespace gr
