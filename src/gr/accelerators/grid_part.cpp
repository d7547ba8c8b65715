#include "gr/accelerators/grid_part.h"

namespace gr {
namespace {

// Adds what change(value) makes of each. Makes room for an eighth more than is needed at most, where the standard's
// growth would take as much again. What was behind is given back at once.
template<class Value, class Change>
void appendChanged(std::vector<Value>& values, std::vector<Value> behind, Change&& change) {
    const std::size_t size = values.size() + behind.size();
    if (size > values.capacity()) values.reserve(std::max(size, values.capacity() + values.capacity() / 8));
    for (const Value& value : behind) values.push_back(change(value));
}

}  // namespace

std::size_t GridPart::bytes() const {
    return levels.capacity() * sizeof(GridLevel) + bricks.capacity() * sizeof(GridBrick) +
           (cells.capacity() + items.capacity()) * sizeof(std::uint32_t);
}

void GridPart::append(GridPart behind, std::size_t firstLevel) {
    if (levels.empty() && items.capacity() < behind.items.size()) {
        *this = std::move(behind);
        return;
    }
    const auto firstBrick = static_cast<std::uint32_t>(bricks.size());
    const auto firstCell = static_cast<std::uint32_t>(cells.size());
    const auto firstItem = static_cast<std::uint32_t>(items.size());
    appendChanged(levels, std::move(behind.levels), [=](GridLevel level) {
        level.firstBrick += firstBrick;
        return level;
    });
    appendChanged(bricks, std::move(behind.bricks), [=](GridBrick brick) {
        brick.firstCell += firstCell;
        return brick;
    });
    appendChanged(cells, std::move(behind.cells), [=](std::uint32_t cell) { return cell + firstItem; });
    const auto levelsBefore = static_cast<std::uint32_t>(firstLevel);
    appendChanged(items, std::move(behind.items),
                  [=](std::uint32_t item) { return (item & isLevel) != 0 ? item + levelsBefore : item; });
}

void GridPart::compact() {
    std::uint32_t end = 0;
    for (std::size_t cell = 0; cell + 1 < cells.size(); ++cell) {
        const std::uint32_t first = cells[cell], last = cells[cell + 1];
        cells[cell] = end;
        if ((items[first] & isLevel) != 0) {
            items[end++] = items[first];
        } else {
            std::copy(items.begin() + first, items.begin() + last, items.begin() + end);
            end += last - first;
        }
    }
    cells.back() = end;
    items.resize(end);
}

void GridPart::shrink() {
    levels.shrink_to_fit();
    bricks.shrink_to_fit();
    cells.shrink_to_fit();
    items.shrink_to_fit();
}

}  // namespace gr
