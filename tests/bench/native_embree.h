// A mesh as Embree's own triangles, as most programs use it.
#pragma once

#include "gr/embree_library.h"
#include "gr/polyhedron.h"

#include "core/ray.h"

namespace bench {

class NativeMesh {
public:
    explicit NativeMesh(const gr::Polyhedron& polyhedron)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        const std::size_t count = polyhedron.triangleCount();
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                     RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
        auto* indices = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
        for (std::uint32_t i = 0; i < 3 * count; ++i) {
            const core::Vec3f v = polyhedron.vertex(i / 3, static_cast<int>(i % 3));
            for (int axis = 0; axis < 3; ++axis) vertices[3 * i + static_cast<unsigned>(axis)] = v[axis];
            indices[i] = i;
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(scene_);
    }
    ~NativeMesh() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    NativeMesh(const NativeMesh&) = delete;
    NativeMesh& operator=(const NativeMesh&) = delete;

    float intersect(const core::Rayf& ray) const {
        RTCRayHit rayHit;
        rayHit.ray = native(ray);
        rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
        rtcIntersect1(scene_, &rayHit);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &rayHit);
#endif
        return rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? core::infinity : rayHit.ray.tfar;
    }

    bool occluded(const core::Rayf& ray) const {
        RTCRay nativeRay = native(ray);
#if RTC_VERSION_MAJOR >= 4
        rtcOccluded1(scene_, &nativeRay);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene_, &context, &nativeRay);
#endif
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
