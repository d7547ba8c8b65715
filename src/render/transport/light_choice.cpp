#include "render/transport/light_choice.h"

#include <numeric>

namespace render {

LightChoice::LightChoice(const gr::Lights& lights) : tree_(lights), first_(static_cast<float>(lights.placed())) {
    std::vector<double> powers;
    lights.forEach([&]<class Light>(const Light& light) {
        if constexpr (Light::isEndless) powers.push_back(light.power());
    });
    if (powers.empty()) return;
    const double all = std::accumulate(powers.begin(), powers.end(), 0.);
    double sum = 0;
    for (const double power : powers) {
        sum += power;
        ends_.push_back(all > 0 ? static_cast<float>(sum / all) : 0.f);
    }
    ends_.back() = 1;
    // What the lights that have places bring differs from point to point; neither half may be asked too seldom.
    endlessShare_ = lights.placed() == 0 ? 1.f : 0.5f;
    restFactor_ = 1 / endlessShare_;
}

}  // namespace render
