#include "gr/mesh/import/joined_mesh.h"

#include "gr/mesh/places.h"
#include "gr/near_origin.h"

#include <algorithm>
#include <array>

namespace gr::importer {
namespace {

bool isCoordinate(const glm::dvec3& place) {
    // Also false for what is no number.
    return std::abs(place.x) <= mostCoordinate && std::abs(place.y) <= mostCoordinate &&
           std::abs(place.z) <= mostCoordinate;
}

// Gives equal places one number, in the order in which they come.
class Joiner {
public:
    Joiner(const std::vector<glm::dvec3>& places, const std::vector<char>& isUsed, const glm::dvec3& origin,
           std::vector<core::Vec3f>& joined)
        : places_(places), isUsed_(isUsed), origin_(origin), joined_(joined) {
        // Where each corner has a vertex of its own, six of them are at one place in most meshes.
        table_.reserve(places.size() / 6);
        joined_.reserve(places.size() / 6);
    }

    // The number of each place.
    std::vector<int> numbers() {
        const std::size_t count = places_.size();
        std::vector<int> numbers(count);
        for (std::size_t i = 0; i < ahead; ++i) prepare(i);
        for (std::size_t i = 0; i < count; ++i) {
            prepare(i + ahead);
            const Place& soon = recent_[(i + ahead / 2) % kept];
            if (soon.back == 0) table_.fetchPlace(joined_.data(), soon.hash);
            const Place& place = recent_[i % kept];
            if (isUsed_[i] != 0) numbers[i] = place.back > 0 ? numbers[i - place.back] : numberOf(place);
        }
        return numbers;
    }

private:
    // In most files a vertex is like one of the few before it, which is quick to see. What others need is fetched
    // ahead.
    static constexpr std::size_t few = 8, ahead = 16, kept = 32;
    struct Place {
        core::Vec3f at = core::Vec3f(std::numeric_limits<float>::quiet_NaN());
        std::size_t back = 0;  // how far before it the one is that it is like, or 0
        std::uint64_t hash = 0;
    };

    void prepare(std::size_t i) {
        if (i >= places_.size()) return;
        Place& place = recent_[i % kept];
        place = {};
        if (isUsed_[i] == 0) return;
        place.at = core::Vec3f(places_[i] - origin_);
        for (place.back = 1; place.back <= few; ++place.back)
            if (recent_[(i - place.back) % kept].at == place.at) return;
        place.back = 0;
        place.hash = table_.hash(place.at);
        table_.fetchSlot(place.hash);
    }

    int numberOf(const Place& place) {
        const int number = static_cast<int>(joined_.size());
        joined_.push_back(place.at);
        const int first = table_.firstLike(joined_.data(), number, place.hash);
        if (first != number) joined_.pop_back();
        return first;
    }

    const std::vector<glm::dvec3>& places_;
    const std::vector<char>& isUsed_;
    glm::dvec3 origin_;
    std::vector<core::Vec3f>& joined_;
    PlaceTable<core::Vec3f> table_;
    std::array<Place, kept> recent_;
};

// Lets neighbours of one name and material be one, and drops them where that tells nothing.
void joinGroups(std::vector<SourceGroup>& groups) {
    const auto isSame = [](const SourceGroup& a, const SourceGroup& b) {
        return a.name == b.name && a.material == b.material;
    };
    groups.erase(std::unique(groups.begin(), groups.end(), isSame), groups.end());
    if (groups.size() == 1 && isSame(groups[0], {})) groups.clear();
}

}  // namespace

JoinedMesh join(SourceMesh&& mesh) {
    if (mesh.corners.empty()) throw Failure("it has no faces");
    std::vector<char> isUsed(mesh.vertices.size(), 0);
    for (const int corner : mesh.corners) isUsed[static_cast<std::size_t>(corner)] = 1;
    glm::dvec3 low(mostCoordinate), high(-mostCoordinate);
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
        if (isUsed[i] == 0) continue;
        if (!isCoordinate(mesh.vertices[i])) throw Failure("a coordinate is not a number from -1e+18 to 1e+18");
        low = glm::min(low, mesh.vertices[i]);
        high = glm::max(high, mesh.vertices[i]);
    }

    JoinedMesh joined{.origin = nearOrigin(low, high), .vertices = {}, .source = std::move(mesh)};
    SourceMesh& source = joined.source;
    const std::vector<int> numbers = Joiner(source.vertices, isUsed, joined.origin, joined.vertices).numbers();
    for (int& corner : source.corners) corner = numbers[static_cast<std::size_t>(corner)];
    source.vertices = {};
    const auto fill = [&](auto& values, const auto& none) {
        if (!values.empty()) values.resize(source.corners.size(), none);
    };
    fill(source.normals, noNormal);
    fill(source.uvs, core::Vec2f(0));
    fill(source.colours, core::Rgbf(1));
    joinGroups(source.groups);
    return joined;
}

}  // namespace gr::importer
