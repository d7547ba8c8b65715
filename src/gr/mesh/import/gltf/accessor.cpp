#include "gr/mesh/import/gltf/accessor.h"

#include "core/error.h"
#include "gr/mesh/import/gltf/words.h"

#include <algorithm>
#include <array>
#include <bit>

namespace gr::importer {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are taken from files as they are there");

constexpr std::array<std::pair<std::string_view, std::size_t>, 7> widths{
    {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};

// Elements that stand in no buffer take no bytes of the file: a short one could announce any number of them.
constexpr std::size_t mostWithoutView = 1 << 24;

// What an accessor without a buffer view looks at: one element, as large as any.
constexpr std::array<char, 64> zeros{};

std::size_t widthOf(const JsonObject& accessor, const std::string& type) {
    for (const auto& [name, width] : widths)
        if (name == type) return width;
    throw Failure(accessor.subjectOf("type") + " is " + inQuotes(type) + ", which is not one of glTF's");
}

Component componentOf(const JsonObject& owner) {
    const std::uint64_t number = owner.neededWhole("componentType");
    const bool isKnown = number >= 5120 && number <= 5126 && number != 5124;
    if (!isKnown)
        throw Failure(owner.subjectOf("componentType") + " is " + std::to_string(number) +
                      " instead of 5120, 5121, 5122, 5123, 5125 or 5126");
    return static_cast<Component>(number);
}

// Elements in a buffer view, all of which must be there. The last one need not fill its stride.
struct Elements {
    const char* bytes;
    std::size_t stride;
};

Elements elementsIn(const GltfDocument& document, GltfBuffers& buffers, const JsonObject& owner, std::size_t count,
                    std::size_t size) {
    const std::size_t index = document.neededNamed(owner, "bufferView", bufferViewKind);
    const GltfBuffers::View view = buffers.view(index);
    const std::size_t stride = view.stride == 0 ? size : view.stride;
    const std::uint64_t offset = owner.whole("byteOffset", 0);
    if (stride < size)
        throw Failure(owner.subject() + " has elements of " + std::to_string(size) + " bytes, but bufferView " +
                      std::to_string(index) + " one in " + std::to_string(stride));
    const bool isWithin = count == 0 || (offset <= view.bytes.size() && size <= view.bytes.size() - offset &&
                                         count - 1 <= (view.bytes.size() - offset - size) / stride);
    if (!isWithin)
        throw Failure(owner.subject() + " has more elements than bufferView " + std::to_string(index) +
                      " holds: " + std::to_string(count) + " of " + std::to_string(size) + " bytes from byte " +
                      std::to_string(offset) + " on, one in " + std::to_string(stride) + ", in " +
                      std::to_string(view.bytes.size()));
    return {count == 0 ? zeros.data() : view.bytes.data() + offset, stride};
}

// Some elements are others than where they stand: a copy of all of them gets those.
void applySparse(const GltfDocument& document, GltfBuffers& buffers, const JsonObject& sparse, Accessor& accessor) {
    const std::size_t size = accessor.width * sizeOf(accessor.component), count = sparse.neededWhole("count");
    const std::optional<JsonObject> indices = sparse.object("indices"), values = sparse.object("values");
    if (!indices || !values) throw Failure(sparse.subject() + " has not both \"indices\" and \"values\"");
    Accessor places;
    places.component = componentOf(*indices);
    places.place = indices->place();
    places.expectUnsigned("an element's number");
    const Elements at = elementsIn(document, buffers, *indices, count, sizeOf(places.component));
    const Elements value = elementsIn(document, buffers, *values, count, size);
    places.bytes = at.bytes;
    places.stride = at.stride;
    const auto copy = std::make_shared<std::string>(accessor.count * size, '\0');
    for (std::size_t i = 0; i < accessor.count; ++i)
        std::memcpy(copy->data() + i * size, accessor.bytes + i * accessor.stride, size);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = places.whole(i, 0);
        if (place >= accessor.count)
            throw Failure(sparse.subject() + " names element " + std::to_string(place) + " of " +
                          std::to_string(accessor.count));
        std::memcpy(copy->data() + place * size, value.bytes + i * value.stride, size);
    }
    accessor.bytes = copy->data();
    accessor.stride = size;
    accessor.owned = copy;
}

}  // namespace

std::size_t sizeOf(Component component) {
    switch (component) {
        case Component::int8:
        case Component::uint8:
            return 1;
        case Component::int16:
        case Component::uint16:
            return 2;
        case Component::int32:
        case Component::uint32:
        case Component::float32:
            return 4;
    }
    return 0;
}

void Accessor::expectType(std::string_view what, std::initializer_list<std::string_view> types) const {
    if (std::find(types.begin(), types.end(), type) != types.end()) return;
    throw Failure("its " + place + " is " + type + ", but " + std::string(what) + " is " +
                  core::listed({types.begin(), types.size()}));
}

void Accessor::expectUnsigned(std::string_view what) const {
    if (component == Component::uint8 || component == Component::uint16 || component == Component::uint32) return;
    throw Failure("its " + place + " has componentType " + std::to_string(static_cast<int>(component)) + ", but " +
                  std::string(what) + " is 5121, 5123 or 5125");
}

Accessor readAccessor(const GltfDocument& document, GltfBuffers& buffers, std::size_t index) {
    const JsonObject object = document.item(accessorKind, index);
    Accessor accessor;
    accessor.place = object.place();
    accessor.type = object.text("type");
    accessor.width = widthOf(object, accessor.type);
    accessor.component = componentOf(object);
    accessor.isNormalised = object.flag("normalized");
    accessor.count = object.neededWhole("count");
    if (object.find("bufferView") != nullptr) {
        const Elements elements =
            elementsIn(document, buffers, object, accessor.count, accessor.width * sizeOf(accessor.component));
        accessor.bytes = elements.bytes;
        accessor.stride = elements.stride;
    } else {
        if (accessor.count > mostWithoutView)
            throw Failure(object.subject() + " has " + std::to_string(accessor.count) +
                          " elements without a bufferView, of which 16777216 are read at most");
        accessor.bytes = zeros.data();
    }
    const std::optional<JsonObject> sparse = object.object("sparse");
    if (sparse) applySparse(document, buffers, *sparse, accessor);
    return accessor;
}

}  // namespace gr::importer
