// Integrals by adaptive Gauss-Kronrod quadrature: for comparing what is sampled with what is meant.
#pragma once

#include <functional>

namespace support {

using Function = std::function<double(double)>;
using Function2d = std::function<double(double, double)>;

struct Integral {
    double value;
    double error;  // an estimate, mostly too large by far
};

// The panel with the largest error is halved until the errors sum to the tolerance, which is absolute, or there are
// mostPanels of them. A value that is not finite makes the integral not finite. No point lies on the boundary.
Integral estimate(const Function& f, double a, double b, double tolerance, int mostPanels);
Integral estimate2d(const Function2d& f, double ax, double bx, double ay, double by, double tolerance, int mostPanels);

// The same for integrals that must come out: they throw std::runtime_error where the tolerance is not reached.
double integrate(const Function& f, double a, double b, double tolerance);
double integrate2d(const Function2d& f, double ax, double bx, double ay, double by, double tolerance);

}  // namespace support
