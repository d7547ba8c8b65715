// Triangles as Embree's own, as most programs use it.
#pragma once

#include "core/ray.h"
#include "gr/accelerators/embree_library.h"

#include <array>
#include <span>

namespace bench {

using Triangle = std::array<core::Vec3f, 3>;

// How a question is asked. Embree 3 and 4 have different words for it.
class NativeQuery {
public:
    // areCoherent: whether the rays of a pack go nearly the same way.
    explicit NativeQuery(bool areCoherent) {
#if RTC_VERSION_MAJOR >= 4
        const RTCRayQueryFlags flags = areCoherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
        rtcInitIntersectArguments(&intersect_);
        rtcInitOccludedArguments(&occluded_);
        intersect_.flags = occluded_.flags = flags;
#else
        rtcInitIntersectContext(&context_);
        context_.flags = areCoherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
#endif
    }

#if RTC_VERSION_MAJOR >= 4
    void ask(RTCScene scene, RTCRayHit& ray) {
        rtcIntersect1(scene, &ray, &intersect_);
    }
    void ask(RTCScene scene, RTCRay& ray) {
        rtcOccluded1(scene, &ray, &occluded_);
    }
    void ask(RTCScene scene, const int* valid, RTCRayHit16& rays) {
        rtcIntersect16(valid, scene, &rays, &intersect_);
    }
    void ask(RTCScene scene, const int* valid, RTCRay16& rays) {
        rtcOccluded16(valid, scene, &rays, &occluded_);
    }

private:
    RTCIntersectArguments intersect_;
    RTCOccludedArguments occluded_;
#else
    void ask(RTCScene scene, RTCRayHit& ray) {
        rtcIntersect1(scene, &context_, &ray);
    }
    void ask(RTCScene scene, RTCRay& ray) {
        rtcOccluded1(scene, &context_, &ray);
    }
    void ask(RTCScene scene, const int* valid, RTCRayHit16& rays) {
        rtcIntersect16(valid, scene, &context_, &rays);
    }
    void ask(RTCScene scene, const int* valid, RTCRay16& rays) {
        rtcOccluded16(valid, scene, &context_, &rays);
    }

private:
    RTCIntersectContext context_;
#endif
};

class NativeTriangles {
public:
    explicit NativeTriangles(std::span<const Triangle> triangles)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        const auto buffer = [&](RTCBufferType type, RTCFormat format, std::size_t count) {
            return rtcSetNewGeometryBuffer(geometry, type, 0, format, 3 * sizeof(float), count);
        };
        const std::size_t count = triangles.size();
        auto* vertices = static_cast<core::Vec3f*>(buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3 * count));
        auto* corners = static_cast<unsigned*>(buffer(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, count));
        for (std::size_t i = 0; i < 3 * count; ++i) {
            vertices[i] = triangles[i / 3][i % 3];
            corners[i] = static_cast<unsigned>(i);
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        // Without it rays slip through between triangles, which ours never do.
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(scene_);
    }
    ~NativeTriangles() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    NativeTriangles(const NativeTriangles&) = delete;
    NativeTriangles& operator=(const NativeTriangles&) = delete;

    RTCScene scene() const { return scene_; }

    // The t of the nearest hit, or infinity.
    float intersect(const core::Rayf& ray, NativeQuery query = NativeQuery(false)) const {
        RTCRayHit rayHit;
        rayHit.ray = native(ray);
        rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.ask(scene_, rayHit);
        return rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? core::infinity : rayHit.ray.tfar;
    }

    bool occluded(const core::Rayf& ray, NativeQuery query = NativeQuery(false)) const {
        RTCRay nativeRay = native(ray);
        query.ask(scene_, nativeRay);
        return nativeRay.tfar < 0;
    }

private:
    static RTCRay native(const core::Rayf& ray) {
        return {ray.origin.x,
                ray.origin.y,
                ray.origin.z,
                0,
                ray.direction.x,
                ray.direction.y,
                ray.direction.z,
                0,
                ray.tMax,
                ~0u,
                0,
                0};
    }

    RTCDevice device_;
    RTCScene scene_;
};

}  // namespace bench
