// What the rays of many paths meet of a scene's flat faces: every ray is tested against every face.
#pragma once

#include "gr/offset.h"
#include "gr/scene.h"
#include "gr/surface_point.h"

namespace gr {

template<class Real>
class FaceTracer {
public:
    using Vec3 = core::Vec3<Real>;
    using Mask = core::Mask<Real>;

    // The faces, by their number: a hit on one has it, and this more, as its instance.
    static constexpr std::uint32_t firstFace = 1u << 31;

    explicit FaceTracer(const FaceList& faces) : faces_(faces) {}

    // The nearest hit before the rays' ends, of any face.
    HitOf<Real> nearest(const core::Ray<Real>& ray) const {
        Real t = ray.tMax, face(-1);
        meet<false>(ray, faces_.parallelograms, 0, t, face);
        meet<true>(ray, faces_.triangles, static_cast<float>(faces_.parallelograms.size()), t, face);
        const Mask isMet = face >= Real(0);
        HitOf<Real> hit;
        hit.t = core::select(isMet, t, Real(core::infinity));
        hit.instance = core::UInt<Real>(firstFace) + core::toUInt(core::select(isMet, face, Real(0)));
        return hit;
    }

    // Whether a face stands between two points of the scene.
    Mask occluded(const core::Ray<Real>& ray) const {
        Mask isMet = Real(0) > Real(0);
        isMet = isMetByAny<false>(ray, faces_.parallelograms, faces_.blockingParallelograms, isMet);
        return isMetByAny<true>(ray, faces_.triangles, faces_.blockingTriangles, isMet);
    }

    // Of the lanes where a face was hit.
    void setSurface(SurfacePoint<Real>& surface, const core::Ray<Real>& ray, const HitOf<Real>& hit, const Mask& isFace,
                    bool wantsCoordinates) const {
        const auto parallelograms = static_cast<float>(faces_.parallelograms.size());
        const Real face = core::toReal(hit.instance & core::UInt<Real>(firstFace - 1));
        if (faces_.triangles.empty()) {
            if (core::any(isFace)) setFace<false>(surface, ray, faces_.parallelograms, face, isFace, wantsCoordinates);
            return;
        }
        const Mask onParallelogram = isFace & (face < Real(parallelograms));
        const Mask onTriangle = isFace & (face >= Real(parallelograms));
        if (core::any(onParallelogram))
            setFace<false>(surface, ray, faces_.parallelograms, face, onParallelogram, wantsCoordinates);
        if (core::any(onTriangle))
            setFace<true>(surface, ray, faces_.triangles, face - Real(parallelograms), onTriangle, wantsCoordinates);
    }

private:
    static Vec3 lanes(const core::Vec3f& v) { return core::broadcast<Real>(v); }

    // Where rays meet a face's plane, and whether that is in the face.
    struct Crossing {
        Real t;
        Mask isInside;
    };
    // A face is taken a hair too large, by what rounding may move the place where the ray meets its plane: along the
    // ray by as much as t is off, which is the more the flatter it comes, and all round by as much as the way to the
    // face is. So nothing slips through between two faces. It is less than the step off a surface, or a ray that leaves
    // one along it would meet what is beyond the next edge.
    template<bool isTriangle>
    static Crossing cross(const core::Ray<Real>& ray, const Face& face) {
        const Vec3 way = lanes(face.corner) - ray.origin;
        const Vec3 normal = lanes(face.normal), toU = lanes(face.toU), toV = lanes(face.toV);
        const Real inverse = Real(1) / glm::dot(normal, ray.direction);
        const Real t = glm::dot(normal, way) * inverse;
        const Vec3 inPlane = ray.direction * t - way;
        const Real u = glm::dot(toU, inPlane), v = glm::dot(toV, inPlane);
        const Real rounding =
            (core::abs(way.x) + core::abs(way.y) + core::abs(way.z) + Real(face.extent)) * Real(0x1p-24f);
        const auto hair = [&](const Vec3& to, float reach) {
            return rounding * (core::abs(glm::dot(to, ray.direction) * inverse) + Real(reach));
        };
        const Real hairU = hair(toU, face.reachU), hairV = hair(toV, face.reachV);
        const Real half(0.5f), one(1);
        const Mask inside = isTriangle ? (u >= -hairU) & (v >= -hairV) & (u + v <= one + (hairU + hairV))
                                       : (core::abs(u - half) <= half + hairU) & (core::abs(v - half) <= half + hairV);
        return {t, inside};
    }

    template<bool isTriangle>
    static void meet(const core::Ray<Real>& ray, const std::vector<Face>& faces, float number, Real& t, Real& nearest) {
        for (const Face& face : faces) {
            const Crossing at = cross<isTriangle>(ray, face);
            const Mask isNearer = at.isInside & (at.t > Real(0)) & (at.t < t);
            t = core::select(isNearer, at.t, t);
            nearest = core::select(isNearer, Real(number), nearest);
            ++number;
        }
    }

    template<bool isTriangle>
    static Mask isMetByAny(const core::Ray<Real>& ray, const std::vector<Face>& faces, std::size_t count, Mask isMet) {
        for (std::size_t i = 0; i < count; ++i) {
            const Crossing at = cross<isTriangle>(ray, faces[i]);
            isMet = isMet | (at.isInside & (at.t > Real(0)) & (at.t < ray.tMax));
        }
        return isMet;
    }

    template<bool isTriangle>
    void setFace(SurfacePoint<Real>& surface, const core::Ray<Real>& ray, const std::vector<Face>& faces,
                 const Real& number, const Mask& here, bool wantsCoordinates) const {
        const core::GatheredRow<Real, Face> row(faces.data(), core::toUInt(core::select(here, number, Real(0))));
        const Vec3 normal = row.vector(offsetof(Face, normal)), corner = row.vector(offsetof(Face, corner));
        Vec3 position = ray.origin + ray.direction * surface.t;
        const Real error = row.number(offsetof(Face, error)) +
                           row.number(offsetof(Face, errorPerUnit)) * core::largestComponent(position);
        // Onto the plane, off which rounding may have put the end of a long way.
        position = position - normal * glm::dot(normal, position - corner);
        // Away from the edges, so that a ray that goes on starts on the right side of the faces beyond them.
        const Vec3 inPlane = position - corner;
        const Real least = core::min(row.number(offsetof(Face, margin)) * error, Real(0.25f));
        const Real u = glm::dot(row.vector(offsetof(Face, toU)), inPlane),
                   v = glm::dot(row.vector(offsetof(Face, toV)), inPlane);
        const Real most = Real(1) - least;
        const Mask isAtEdge = here & ((core::min(u, v) < least) | ((isTriangle ? u + v : core::max(u, v)) > most));
        if (core::any(isAtEdge)) {
            const Real b1 = isTriangle ? core::max(u, least) : core::min(core::max(u, least), most);
            const Real b2 = isTriangle ? core::max(v, least) : core::min(core::max(v, least), most);
            const Real sum = isTriangle ? core::max(Real(1) - u - v, least) + b1 + b2 : Real(1);
            const Vec3 inside = corner + row.vector(offsetof(Face, edge1)) * (b1 / sum) +
                                row.vector(offsetof(Face, edge2)) * (b2 / sum);
            position = core::select(isAtEdge, inside, position);
        }
        surface.position = core::select(here, position, surface.position);
        surface.lifted = core::select(here, position, surface.lifted);
        surface.normal = core::select(here, normal, surface.normal);
        surface.shadingNormal = core::select(here, normal, surface.shadingNormal);
        surface.step = core::select(here, offsetBeyond<Real>(Vec3(error), normal), surface.step);
        surface.material = core::select(here, row.number(offsetof(Face, material)), surface.material);
        surface.light = core::select(here, row.number(offsetof(Face, light)), surface.light);
        if (!wantsCoordinates) return;
        const auto coordinate = [&](std::size_t axis) {
            const auto part = [&](std::size_t member) { return row.number(member + axis * sizeof(float)); };
            return part(offsetof(Face, uv)) + part(offsetof(Face, uvAlong1)) * u + part(offsetof(Face, uvAlong2)) * v;
        };
        surface.uv.x = core::select(here, coordinate(0), surface.uv.x);
        surface.uv.y = core::select(here, coordinate(1), surface.uv.y);
        surface.tangent = core::select(here, row.vector(offsetof(Face, tangent)), surface.tangent);
        if (!faces_.hasNodeSpaces) return;
        const Vec3 inNode = row.vector(offsetof(Face, inNode)) + row.vector(offsetof(Face, inNodeAlong1)) * u +
                            row.vector(offsetof(Face, inNodeAlong2)) * v;
        surface.inNode = core::select(here, inNode, surface.inNode);
    }

    const FaceList& faces_;
};

}  // namespace gr
