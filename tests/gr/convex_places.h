// Convex shapes at sizes from 10^-3 to 10^4 and up to a thousand times their size away, and the rays that find out
// whether a path that leaves one goes on where it should.
#pragma once

#include "core/frame.h"
#include "gr/random_shapes.h"
#include "gr/scene.h"

#include <sstream>

namespace gr {

// What went wrong: how often, and the numbers of the first times.
class Violations {
public:
    template<class... Parts>
    void add(const Parts&... parts) {
        if (++count_ > 5) return;
        std::ostringstream text;
        text.precision(9);
        (text << ... << parts);
        text_ += text.str() + "\n";
    }
    int count() const { return count_; }
    const std::string& text() const { return text_; }

private:
    int count_ = 0;
    std::string text_;
};

struct ConvexShape {
    const char* name;
    NodeContent content;  // fills [-1, 1]^3
    bool isRound;
    bool isFlat;
    bool isMesh;
    glm::dvec3 inside{0};  // a place within
};

inline std::vector<ConvexShape> convexShapes() {
    return {{"Sphere", SphereNode{}, true, false, false},
            {"Box", BoxNode{glm::dvec3(-1), glm::dvec3(2)}, false, false, false},
            {"CubeMesh", polyhedronNode(cubeMesh()), false, false, true},
            {"Icosphere", polyhedronNode(icosphereMesh(1)), true, false, true},
            {"Cylinder", CylinderNode{{0, -1, 0}, 1, 2}, true, false, false},
            {"Cone", ConeNode{{0, -1, 0}, 1, 2, 0}, true, false, false},
            {"ConeCut", ConeNode{{0, -1, 0}, 1, 2, 0.3}, true, false, false},
            {"Cup", ConeNode{{0, -1, 0}, 0.3, 2, 1}, true, false, false},
            {"Square", AreaLightNode{core::Rgbf(1), glm::dvec3(0), 2}, false, true, false},
            {"Disc", DiscNode{}, false, true, false},
            {"Ring", DiscNode{.hole = 0.5}, false, true, false}};
}

inline std::vector<ConvexShape> convexSolids() {
    std::vector<ConvexShape> shapes = convexShapes();
    std::erase_if(shapes, [](const ConvexShape& shape) { return shape.isFlat; });
    return shapes;
}

// Shapes that hold what is inside of them.
inline std::vector<ConvexShape> closedShapes() {
    std::vector<ConvexShape> shapes = convexSolids();
    shapes.push_back({"Torus", TorusNode{.radius = 0.75, .tube = 0.25}, true, false, false, {0.75, 0, 0}});
    shapes.push_back({"ThinTorus", TorusNode{.radius = 0.98, .tube = 0.02}, true, false, false, {0.98, 0, 0}});
    shapes.push_back({"FatTorus", TorusNode{.radius = 0.52, .tube = 0.48}, true, false, false, {0, 0, 0.52}});
    return shapes;
}

// A shape turned and stretched at random.
struct ConvexPlace {
    const ConvexShape& shape;
    double size, distance;  // the distance in sizes
    glm::dmat4 matrix{1};
    Scene scene;
    std::unique_ptr<Accelerator> accelerator;

    // more: called as more(database, *this) to add what else there is; the shape is under ":place".
    template<class More>
    ConvexPlace(const ConvexShape& shape, double size, double distance, support::TestRandom& random, More&& more)
        : shape(shape), size(size), distance(distance) {
        Database database;
        database.create(":", "place", TransformNode{});
        database.translate(":place", randomDirection(random) * (distance * size));
        // So far away a thin shape would be lost in the spacing of single precision.
        squeezeAtRandom(database, ":place", size, distance > 100 ? 1 : 2, random);
        database.create(":place", "shape", shape.content);
        matrix = *database.find(":place").matrix;
        more(database, *this);
        scene = compile(database, ":", {});
        accelerator = makeNoAccelerator(scene);
    }

    core::Vec3f toWorld(const glm::dvec3& point) const { return core::Vec3f(transformed(matrix, point)); }
    std::string text() const {
        std::ostringstream text;
        text << shape.name << " of size " << size << ", " << distance << " sizes away";
        return text.str();
    }

    // From outside, often to where an edge or the silhouette is.
    core::Rayf rayFromOutside(support::TestRandom& random) const {
        glm::dvec3 from = randomDirection(random) * (2 + 8 * random.next() * random.next());
        glm::dvec3 to = randomPoint(random, -1, 1);
        if (shape.isRound) to = glm::normalize(to);
        const double hair = std::pow(10, -5 - 3 * random.next());
        if (shape.isRound && random.next() < 0.3) {
            const glm::dvec3 along = glm::normalize(glm::cross(to, randomDirection(random)));
            from = to * (1 - hair) + along * (1 + 5 * random.next());
        } else if (random.next() < 0.3) {
            for (int i = 0; i < 2; ++i) to[static_cast<int>(3 * random.next())] = random.next() < 0.5 ? -1 : 1;
            to += randomDirection(random) * hair;
        }
        if (shape.isFlat) to.y = 0;
        const core::Vec3f origin = toWorld(from);
        return {origin, glm::normalize(toWorld(to) - origin)};
    }
};

// Where nothing stands beside the shape.
inline void alone(Database&, const ConvexPlace&) {}

// Calls visit(place) for places of every size and distance, some of each. more: see ConvexPlace.
template<class More, class Visit>
void forEachPlace(const ConvexShape& shape, int placesOfEach, support::TestRandom& random, More&& more, Visit&& visit) {
    for (int exponent = -3; exponent <= 4; ++exponent)
        for (const double distance : {0., 10., 1000.})
            for (int i = 0; i < placesOfEach; ++i)
                visit(ConvexPlace(shape, std::pow(10, exponent), distance, random, more));
}

// A direction of the hemisphere round a normal: half of them uniform, as a path goes on, half of them nearly along the
// surface.
inline core::Vec3f leave(const core::Vec3f& normal, support::TestRandom& random) {
    const double height = random.next() < 0.5 ? random.next() : std::pow(10, -8 * random.next());
    const float z = core::min(core::max(static_cast<float>(height), 0x1p-24f), 1 - 0x1p-24f);
    const float turns = static_cast<float>(random.nextBits() >> 40) * 0x1p-24f;
    return core::Frame<float>(normal).toWorld(core::squareToUniformHemisphere(core::Vec2f(z, turns)));
}

}  // namespace gr
