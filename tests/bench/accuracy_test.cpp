// The references of the scenes for error against run time, each on two roads that share no code:
// Runge-Kutta on rows, and reduced coordinates or the equation of motion of the crank's angle.
#include <algorithm>
#include <array>
#include <cmath>

#include "bench/accuracy.h"
#include "bench/runge_kutta.h"
#include "reduced/reduced.h"
#include "tests/oracle/test.h"

using namespace joints::bench;

namespace {

constexpr int finest = 3840;  // steps per second: h/64 of 1/60 s

// Where the tip is at the end, after steps of this length.
template <class Move>
glm::dvec3 tip_after(const AccuracyScene& scene, int rate, Move move) {
  BenchScene moved = scene.make();
  const int steps = int(std::lround(moved.tip_time * rate));
  for (int n = 0; n < steps; ++n) move(moved.world, real(1) / real(rate));
  return glm::dvec3(moved.world.bodies.at(moved.tip).x);
}
glm::dvec3 by_rows(const AccuracyScene& scene, int rate) {
  RungeKutta method;
  return tip_after(scene, rate, [&](World& world, real h) { method.step(world, h); });
}
glm::dvec3 by_coordinates(const AccuracyScene& scene, int rate) {
  const BenchScene start = scene.make();
  Reduced tree(start.world);
  tree.method = Reduced::Method::runge_kutta;
  return tip_after(scene, rate, [&](World& world, real h) { tree.step(world, h); });
}

// ---- a linkage by the angle of its crank --------------------------------------------------------

using number = long double;
struct Point {
  number x = 0, y = 0;
};
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(number s, Point a) { return {s * a.x, s * a.y}; }
number dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
number size(Point a) { return std::sqrt(dot(a, a)); }
Point along(number angle) { return {std::cos(angle), std::sin(angle)}; }

// The middle of a bar from one point to another, and its direction.
struct Bar {
  Point middle, direction;
};
Bar bar(Point a, Point b) { return {0.5L * (a + b), 1 / size(b - a) * (b - a)}; }
using Bars = std::array<Bar, 3>;  // crank, coupler, and the third one

// The intersection of two circles to the left of the way from a to b.
Point meet(Point a, number from_a, Point b, number from_b) {
  const Point way = b - a;
  const number d = size(way), t = (from_a * from_a - from_b * from_b + d * d) / (2 * d);
  const Point e = 1 / d * way;
  return a + t * e + std::sqrt(from_a * from_a - t * t) * Point{-e.y, e.x};
}

const number right = std::acos(number(-1)) / 180;  // a degree [rad]

Bars four_bar(number angle) {
  const Point pivot{1, 0}, a0 = 0.5L * along(60 * right), b0 = pivot + 0.8L * along(80 * right);
  const Point a = 0.5L * along(angle), b = meet(a, size(b0 - a0), pivot, 0.8L);
  return {bar({}, a), bar(a, b), bar(pivot, b)};
}
Bars slider_crank(number angle) {
  const Point a = 0.2L * along(angle), b{a.x + std::sqrt(0.36L - a.y * a.y), 0};
  return {bar({}, a), bar(a, b), Bar{b, {1, 0}}};
}

// Lagrange's equation of one coordinate: derivatives by differences of five points.
template <class Shape>
glm::dvec3 by_crank(const AccuracyScene& scene, Shape shape, int steps = 20000) {
  const std::array<int, 3> slots{1, 2, 3};
  const BenchScene start = scene.make();
  std::array<number, 3> mass, inertia;
  for (std::size_t k = 0; k < 3; ++k) {
    const Body& body = start.world.bodies.at(slots[k]);
    mass[k] = 1 / number(body.inverse_mass), inertia[k] = 1 / number(body.inverse_inertia_local.z);
  }
  const number torque = number(start.world.bodies.at(slots[0]).torque.z), e = 1e-3L;
  const auto acceleration = [&](number q, number rate) {
    const std::array<Bars, 5> at{shape(q - 2 * e), shape(q - e), shape(q), shape(q + e),
                                 shape(q + 2 * e)};
    number M = 0, change = 0, force = torque;  // twice the energy at rate 1; half its derivative
    for (std::size_t k = 0; k < 3; ++k)
      for (const auto part : {&Bar::middle, &Bar::direction}) {
        const auto p = [&](int n) { return at[std::size_t(n)][k].*part; };
        const Point first = 1 / (12 * e) * (p(0) - 8 * p(1) + 8 * p(3) - p(4));
        const Point second =
            1 / (12 * e * e) * (16 * p(1) + 16 * p(3) - p(0) - p(4) - 30 * p(2));
        const number weight = part == &Bar::middle ? mass[k] : inertia[k];
        M += weight * dot(first, first);
        change += weight * dot(first, second);
        if (part == &Bar::middle) force += mass[k] * number(start.world.gravity.y) * first.y;
      }
    return (force - change * rate * rate) / M;
  };
  const number h = number(start.tip_time) / steps;
  number q = 60 * right, v = 0;
  for (int n = 0; n < steps; ++n) {
    const number a1 = acceleration(q, v), v2 = v + h / 2 * a1;
    const number a2 = acceleration(q + h / 2 * v, v2), v3 = v + h / 2 * a2;
    const number a3 = acceleration(q + h / 2 * v2, v3), v4 = v + h * a3;
    const number a4 = acceleration(q + h * v3, v4);
    q += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  const Bars end = shape(q);
  const auto at = std::find(slots.begin(), slots.end(), start.tip) - slots.begin();
  const Bar& tip = end[std::size_t(at)];
  return {double(tip.middle.x), double(tip.middle.y), 0};
}

}  // namespace

TEST_CASE("the references of the accuracy scenes are the same on two roads") {
  for (const AccuracyScene& scene : accuracy_scenes()) {
    INFO(scene.key);
    const glm::dvec3 reference = scene.make().tip_reference, rows = by_rows(scene, finest);
    const glm::dvec3 other = scene.is_tree ? by_coordinates(scene, finest)
                             : scene.key == "slider-crank" ? by_crank(scene, slider_crank)
                                                           : by_crank(scene, four_bar);
    CHECK(glm::length(rows - other) < 1e-9);
    CHECK(glm::length(reference - other) < 1e-9);
  }
}
