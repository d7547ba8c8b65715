#include "support/quadrature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace support {

namespace {

// Kronrod's extension of Gauss's three points on [-1, 1] to seven: exact to degree 11, the three alone to degree 5.
// The difference of the two sums bounds the error.
struct Node {
    double x, kronrod, gauss;
};
constexpr std::array<Node, 7> nodes = {{
    {-0.9604912687080202834, 0.1046562260264672652, 0},
    {-0.7745966692414833770, 0.2684880898683334407, 5.0 / 9},
    {-0.4342437493468025580, 0.4013974147759622229, 0},
    {0, 0.4509165386584741423, 8.0 / 9},
    {0.4342437493468025580, 0.4013974147759622229, 0},
    {0.7745966692414833770, 0.2684880898683334407, 5.0 / 9},
    {0.9604912687080202834, 0.1046562260264672652, 0},
}};

// A range of the integrand, with the middle and the half width in each direction.
struct Panel {
    double x, halfX;
    double y = 0, halfY = 0;
    double value = 0;
    double error = 0;
    bool splitX = true;  // the direction in which halving helps most
};

bool smallerError(const Panel& a, const Panel& b) {
    return a.error < b.error;
}

void measure(const Function& f, Panel& panel) {
    double kronrod = 0, gauss = 0;
    for (const Node& node : nodes) {
        const double value = f(panel.x + panel.halfX * node.x);
        kronrod += node.kronrod * value;
        gauss += node.gauss * value;
    }
    panel.value = panel.halfX * kronrod;
    panel.error = std::abs(panel.halfX * (kronrod - gauss));
}

void measure2d(const Function2d& f, Panel& panel) {
    double kronrod = 0, gaussInX = 0, gaussInY = 0;
    for (const Node& nodeX : nodes) {
        for (const Node& nodeY : nodes) {
            const double value = f(panel.x + panel.halfX * nodeX.x, panel.y + panel.halfY * nodeY.x);
            kronrod += nodeX.kronrod * nodeY.kronrod * value;
            gaussInX += nodeX.gauss * nodeY.kronrod * value;
            gaussInY += nodeX.kronrod * nodeY.gauss * value;
        }
    }
    const double area = panel.halfX * panel.halfY;
    const double errorX = std::abs(area * (kronrod - gaussInX));
    const double errorY = std::abs(area * (kronrod - gaussInY));
    panel.value = area * kronrod;
    panel.error = errorX + errorY;
    panel.splitX = errorX >= errorY;
}

std::array<Panel, 2> halves(const Panel& panel) {
    Panel low = panel, high = panel;
    double Panel::*middle = panel.splitX ? &Panel::x : &Panel::y;
    double Panel::*half = panel.splitX ? &Panel::halfX : &Panel::halfY;
    low.*half = high.*half = panel.*half / 2;
    low.*middle -= low.*half;
    high.*middle += high.*half;
    return {low, high};
}

Integral refine(const Panel& whole, const std::function<void(Panel&)>& measured, double tolerance, int mostPanels) {
    std::vector<Panel> heap = {whole};
    measured(heap.front());
    double error = heap.front().error;
    // An error that is not a number ends it too: no comparison holds for it.
    while (error > tolerance && heap.size() < static_cast<std::size_t>(mostPanels)) {
        std::pop_heap(heap.begin(), heap.end(), smallerError);
        const Panel worst = heap.back();
        heap.pop_back();
        error -= worst.error;
        for (Panel panel : halves(worst)) {
            measured(panel);
            error += panel.error;
            heap.push_back(panel);
            std::push_heap(heap.begin(), heap.end(), smallerError);
        }
    }
    double value = 0;
    for (const Panel& panel : heap) value += panel.value;
    return {value, error};
}

double reached(const Integral& integral, double tolerance) {
    if (!std::isfinite(integral.value)) throw std::runtime_error("integral: a value is not finite");
    if (integral.error > tolerance) throw std::runtime_error("integral: the tolerance cannot be reached");
    return integral.value;
}

}  // namespace

Integral estimate(const Function& f, double a, double b, double tolerance, int mostPanels) {
    const Panel whole{.x = (a + b) / 2, .halfX = (b - a) / 2};
    return refine(
        whole, [&f](Panel& panel) { measure(f, panel); }, tolerance, mostPanels);
}

Integral estimate2d(const Function2d& f, double ax, double bx, double ay, double by, double tolerance, int mostPanels) {
    const Panel whole{.x = (ax + bx) / 2, .halfX = (bx - ax) / 2, .y = (ay + by) / 2, .halfY = (by - ay) / 2};
    return refine(
        whole, [&f](Panel& panel) { measure2d(f, panel); }, tolerance, mostPanels);
}

double integrate(const Function& f, double a, double b, double tolerance) {
    return reached(estimate(f, a, b, tolerance, 10'000), tolerance);
}

double integrate2d(const Function2d& f, double ax, double bx, double ay, double by, double tolerance) {
    return reached(estimate2d(f, ax, bx, ay, by, tolerance, 100'000), tolerance);
}

}  // namespace support
