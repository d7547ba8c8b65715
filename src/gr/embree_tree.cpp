#include "gr/embree_tree.h"

#include "core/error.h"
#include "core/parallel.h"
#include "gr/embree_library.h"
#include "gr/parts.h"

#include <bit>
#include <cmath>
#include <limits>

namespace gr {

using core::Bounds;
using core::Vec3f;

namespace {

const EmbreeLibrary& embree() {
    static const EmbreeLibrary& library = EmbreeLibrary::get();
    return library;
}

// Up to how many times the reach of the items away a ray may start for the first shell of boxes, and how much farther
// for each next one. What comes from beyond the last is rounded by as much as all items fill.
constexpr float nearestShell = 8, shellRatio = 32;

// The power of two below a positive number.
float powerOfTwo(float x) {
    const float power = std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) & 0x7f800000u);
    return std::max(power, std::numeric_limits<float>::min());
}

}  // namespace

EmbreeDevice::EmbreeDevice() : device_(embree().rtcNewDevice(nullptr)) {
    if (device_ == nullptr) throw core::Error("ACCELERATOR", "EMBREE", "embree", "Embree does not run here");
    const auto count = [](void* bytes, ssize_t change, bool) {
        static_cast<std::atomic<std::ptrdiff_t>*>(bytes)->fetch_add(change, std::memory_order_relaxed);
        return true;
    };
    embree().rtcSetDeviceMemoryMonitorFunction(device_, count, &bytes_);
}

EmbreeDevice::~EmbreeDevice() {
    embree().rtcReleaseDevice(device_);
}

void EmbreeDevice::check() const {
    const RTCError error = embree().rtcGetDeviceError(device_);
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    if (error != RTC_ERROR_NONE)
        throw core::Error("ACCELERATOR", "EMBREE", std::to_string(error),
                          "Embree cannot build its tree (error " + std::to_string(error) + ")");
}

// One ray on its way, as Embree hands it to the items it passes.
#if RTC_VERSION_MAJOR >= 4
struct EmbreeTree::Walk : RTCRayQueryContext {
#else
struct EmbreeTree::Walk : RTCIntersectContext {
#endif
    const float* nearest;
    Call call;
    void* visit;
    double length;  // of the ray as Embree sees it, for each t

    // A little beyond the nearest hit: what is as near as that must be visited, too.
    float end() const {
        constexpr double margin = 1 + 0x1p-20;
        const double end = static_cast<double>(*nearest) * length * margin + 1e-30;
        return end < std::numeric_limits<float>::max() ? static_cast<float>(end) : core::infinity;
    }

    static void visitItem(const RTCIntersectFunctionNArguments* arguments) {
        const Walk& walk = *static_cast<Walk*>(arguments->context);
        float& end = reinterpret_cast<RTCRayHit*>(arguments->rayhit)->ray.tfar;
        const float before = *walk.nearest;
        if (walk.call(walk.visit, arguments->primID))
            end = -core::infinity;
        else if (*walk.nearest != before)
            end = walk.end();
    }
};

EmbreeTree::EmbreeTree(const EmbreeDevice& device, std::uint32_t count, BoundsOf boundsOf, float errorPerUnit,
                       int threads)
    : device_(device), count_(count), boundsOf_(std::move(boundsOf)), errorPerUnit_(errorPerUnit), threads_(threads) {
    for (const float reach : ofParts<float>(static_cast<int>(count_), threads_, [&](int first, int end) {
             float part = 0;
             for (int i = first; i < end; ++i) part = std::max(part, boundsOf_(static_cast<std::uint32_t>(i)).reach());
             return part;
         }))
        reach_ = std::max(reach_, reach);
    if (reach_ > 0) scale_ = 1 / powerOfTwo(reach_);
    if (count_ > 0) sceneFor(0);
}

EmbreeTree::~EmbreeTree() {
    for (const Shell& shell : shells_)
        if (shell.scene != nullptr) embree().rtcReleaseScene(shell.scene);
}

// Null where no box would keep a ray out that starts so far away.
RTCSceneTy* EmbreeTree::sceneFor(float distance) const {
    float limit = nearestShell * reach_;
    for (Shell& shell : shells_) {
        if (distance <= limit) {
            // On its way a ray is never farther away than where it starts and where it hits together. Embree's own
            // tests of boxes (for geometry that is not its own, its fast ones only) move their sides by less than the
            // second.
            const float widening = (errorPerUnit_ + 0x1p-21f) * 2 * (limit + reach_);
            std::call_once(shell.isMade, [&] { shell.scene = make(widening); });
            return shell.scene;
        }
        limit *= shellRatio;
    }
    return nullptr;
}

RTCSceneTy* EmbreeTree::make(float widening) const {
    struct Boxes {
        const EmbreeTree& tree;
        float widening;
    } boxes{*this, widening};
    const auto boundsOf = [](const RTCBoundsFunctionArguments* arguments) {
        const Boxes& boxes = *static_cast<const Boxes*>(arguments->geometryUserPtr);
        const Bounds wide = boxes.tree.boundsOf_(arguments->primID).widened(boxes.widening);
        const Vec3f low = wide.low * boxes.tree.scale_, high = wide.high * boxes.tree.scale_;
        *arguments->bounds_o = {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
    };
    const EmbreeLibrary& rtc = embree();
    const RTCGeometry geometry = rtc.rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER);
    rtc.rtcSetGeometryUserPrimitiveCount(geometry, count_);
    rtc.rtcSetGeometryUserData(geometry, &boxes);
    rtc.rtcSetGeometryBoundsFunction(geometry, boundsOf, nullptr);
    rtc.rtcSetGeometryIntersectFunction(geometry, Walk::visitItem);
    rtc.rtcCommitGeometry(geometry);
    const RTCScene scene = rtc.rtcNewScene(device_.get());
    rtc.rtcAttachGeometry(scene, geometry);
    rtc.rtcReleaseGeometry(geometry);
    // Embree, too, runs on TBB: as many threads as are allowed here.
    core::parallelFor(1, threads_, [&](int) { rtc.rtcCommitScene(scene); });
    device_.check();
    return scene;
}

void EmbreeTree::walk(const core::Rayf& ray, const float& nearest, Call call, void* visit) const {
    const RTCScene scene = sceneFor(core::largestComponent(ray.origin));
    // Embree ends the program at what is no ray.
    if (scene == nullptr || !core::isFinite(ray.origin) || !core::isFinite(ray.direction) || std::isnan(nearest)) {
        for (std::uint32_t i = 0; i < count_; ++i)
            if (call(visit, i)) return;
        return;
    }
    Walk walk;
    walk.nearest = &nearest;
    walk.call = call;
    walk.visit = visit;
    // Powers of two round nothing.
    const float speed = powerOfTwo(core::largestComponent(ray.direction));
    walk.length = static_cast<double>(speed) * scale_;
    const Vec3f origin = ray.origin * scale_, direction = ray.direction * (1 / speed);
    RTCRayHit rayHit;
    rayHit.ray = {origin.x, origin.y, origin.z, 0, direction.x, direction.y, direction.z, 0, walk.end(), ~0u, 0, 0};
    rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcInitRayQueryContext(&walk);
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &walk;
    embree().rtcIntersect1(scene, &rayHit, &arguments);
#else
    rtcInitIntersectContext(&walk);
    embree().rtcIntersect1(scene, &walk, &rayHit);
#endif
}

}  // namespace gr
