// A tree of boxes without Embree, for what must be there where that is not, and is small: the operands of a CSG object.
#pragma once

#include "gr/accelerators/wide_tree.h"

namespace gr {

// Halves, and halves of halves, until there are eight or each is a leaf; cut at the median across the longest way from
// middle to middle. Takes n log n. Arguments as a WideTree has them; nodes and leaves are put into `memory`.
TreeReference medianTree(std::uint32_t count, const WideTree::BoundsOf& boundsOf, const WideTree::MakeLeaf& makeLeaf,
                         TreeMemory& memory);

}  // namespace gr
