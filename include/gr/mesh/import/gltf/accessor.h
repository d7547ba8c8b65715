// Numbers in a glTF file's buffers.
#pragma once

#include "gr/mesh/import/gltf/buffers.h"

#include <cstring>
#include <memory>

namespace gr::importer {

// As glTF numbers them.
enum class Component { int8 = 5120, uint8, int16, uint16, int32, uint32, float32 };

// In bytes; 0 where there is no such component.
std::size_t sizeOf(Component component);

// So many elements of one type. It looks at bytes that others hold, unless it has some of its own.
struct Accessor {
    std::string place;  // such as "accessor 3"
    std::string type;  // "SCALAR", "VEC3", ...
    std::size_t width = 1;  // numbers in an element
    Component component = Component::float32;
    bool isNormalised = false;
    std::size_t count = 0;  // of elements
    const char* bytes = nullptr;
    std::size_t stride = 0;  // in bytes; 0: all elements are at the same place
    std::shared_ptr<const std::string> owned;

    // index: within the element. What is normalised is from 0 to 1, or from -1 to 1.
    double number(std::size_t element, std::size_t index) const;
    glm::dvec3 vector(std::size_t element) const {
        return {number(element, 0), number(element, 1), number(element, 2)};
    }
    // As it is in the file. Of unsigned components only: see expectUnsigned.
    std::uint32_t whole(std::size_t element, std::size_t index) const;

    // Throws Failure where its type is not among those; what: that which it is to be, for the message.
    void expectType(std::string_view what, std::initializer_list<std::string_view> types) const;
    // The same where its numbers are not whole ones that have no sign.
    void expectUnsigned(std::string_view what) const;

private:
    template<class T>
    T raw(std::size_t element, std::size_t index) const {
        T value;
        std::memcpy(&value, bytes + element * stride + index * sizeof(T), sizeof(T));
        return value;
    }
    template<class T>
    double scaled(std::size_t element, std::size_t index) const {
        const double value = raw<T>(element, index);
        return isNormalised ? std::max(value / std::numeric_limits<T>::max(), -1.0) : value;
    }
};

inline double Accessor::number(std::size_t element, std::size_t index) const {
    switch (component) {
        case Component::int8:
            return scaled<std::int8_t>(element, index);
        case Component::uint8:
            return scaled<std::uint8_t>(element, index);
        case Component::int16:
            return scaled<std::int16_t>(element, index);
        case Component::uint16:
            return scaled<std::uint16_t>(element, index);
        case Component::int32:
            return scaled<std::int32_t>(element, index);
        case Component::uint32:
            return scaled<std::uint32_t>(element, index);
        case Component::float32:
            return raw<float>(element, index);
    }
    return 0;
}

inline std::uint32_t Accessor::whole(std::size_t element, std::size_t index) const {
    switch (component) {
        case Component::uint8:
            return raw<std::uint8_t>(element, index);
        case Component::uint16:
            return raw<std::uint16_t>(element, index);
        default:
            return raw<std::uint32_t>(element, index);
    }
}

// Throws Failure where its elements are not all within its buffer view, or where it has none and is large.
Accessor readAccessor(const GltfDocument& document, GltfBuffers& buffers, std::size_t index);

}  // namespace gr::importer
