#include "core/error.h"
#include "render/transport/lanes_choice.h"
#include "render/transport/path_setup.h"

#include <algorithm>

namespace render {
namespace {

// How many paths are followed at once.
struct Choice {
    core::Word name;
    bool isThere;  // on this processor
    Integrator* (*make)(PathSetup&& setup);
};

std::span<const Choice> choices() {
#ifdef GRSH_X86
    __builtin_cpu_init();
    static const bool hasAvx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    static const bool hasAvx512 = hasAvx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                                  __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                                  __builtin_cpu_supports("avx512vl");
    static const auto widest = hasAvx512 ? grsh_path_integrator_avx512
                               : hasAvx2 ? grsh_path_integrator_avx2
                                         : grsh_path_integrator_baseline;
    static const std::array<Choice, 5> all{{{"auto", true, widest},
                                            {"float", true, grsh_path_integrator_float},
                                            {"sse4.2", true, grsh_path_integrator_baseline},
                                            {"avx2", hasAvx2, grsh_path_integrator_avx2},
                                            {"avx512", hasAvx512, grsh_path_integrator_avx512}}};
#else
    static const std::array<Choice, 5> all{{{"auto", true, grsh_path_integrator_baseline},
                                            {"float", true, grsh_path_integrator_float},
                                            {"sse4.2", false, nullptr},
                                            {"avx2", false, nullptr},
                                            {"avx512", false, nullptr}}};
#endif
    return all;
}

const Choice& choiceOf(core::Word lanes) {
    const std::span<const Choice> all = choices();
    return *std::find_if(all.begin(), all.end(), [&](const Choice& c) { return c.name == lanes; });
}

// The samples of all lights at a surface point are numbered.
void checkLightSamples(const gr::Scene& scene, const RenderSettings& settings) {
    int lights = 0;
    scene.lights.forEach([&]<class Light>(const Light&) { lights += Light::hasPlaces ? 1 : 0; });
    const int most = std::numeric_limits<int>::max() / std::max(lights, 1);
    if (settings.samplesPerLightSource <= most) return;
    const std::string given = std::to_string(settings.samplesPerLightSource);
    throw core::Error("VALUE", "RANGE", given,
                      "samplesperlightsource must be an integer from 1 to " + std::to_string(most) + " with " +
                          std::to_string(lights) + " lamps, not \"" + given + "\"");
}

}  // namespace

std::span<const core::Word> laneNames() {
    static const auto names = [] {
        std::array<core::Word, 5> names;
        std::transform(choices().begin(), choices().end(), names.begin(), [](const Choice& c) { return c.name; });
        return names;
    }();
    return names;
}

void checkLanes(core::Word lanes) {
    if (choiceOf(lanes).isThere) return;
    std::string there;
    for (const Choice& choice : choices())
        if (choice.isThere) there += (there.empty() ? "" : ", ") + std::string(choice.name);
    throw core::Error("VALUE", "LANES", std::string(lanes),
                      "this processor has no \"" + std::string(lanes) + "\": lanes must be one of " + there);
}

std::unique_ptr<Integrator> makePathIntegrator(const gr::Scene& scene, const gr::Accelerator& accelerator,
                                               const RenderSettings& settings, const core::Rgbf& ambient,
                                               const RayStarts& starts) {
    // To ask each of a few lights takes away more noise than it costs time.
    constexpr std::size_t few = 4;
    const bool picksLights = scene.lights.size() > few && scene.lights.size() <= LightTree::mostLights;
    if (!picksLights) checkLightSamples(scene, settings);
    PathSetup setup{PathScene(scene, accelerator),
                    settings.globalIllumination ? settings.pathLength : 1,
                    settings.samplesPerLightSource,
                    picksLights,
                    settings.background,
                    ambient,
                    {}};
    if (setup.scene.hasInteriors) setup.eyeMedia = EyeMedia(scene, starts);
    return std::unique_ptr<Integrator>(choiceOf(settings.lanes).make(std::move(setup)));
}

}  // namespace render
