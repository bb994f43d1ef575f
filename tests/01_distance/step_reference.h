// A step beside the reader's, exercise 1.4.
#pragma once

#include <algorithm>
#include <numeric>

#include "chapters/01_distance/distance.h"
#include "tests/checker/cases.h"
#include "tests/checker/unit_rates.h"

namespace joints::testing {

/// Bodies and links, and how they are to be stepped.
struct Scene {
  std::string words;
  std::vector<Body> bodies;
  std::vector<Link> links;
  StepSettings settings;
  int steps = 1;
};

/// The indices of the links in the order in which an iteration solves them.
using Order = Call<std::vector<int>(int links, int iteration)>;

/// A step may solve the links in any of these orders.
inline std::vector<Order> right_orders() {
  std::vector<Order> orders;
  for (int k = 0; k < 4; ++k)
    orders.push_back([=](int links, int n) {
      std::vector<int> out(std::size_t(links), 0);
      std::iota(out.begin(), out.end(), 0);
      if (n % 2 ? k / 2 : k % 2) std::reverse(out.begin(), out.end());
      return out;
    });
  return orders;
}

/// Eq. 1-4, 1-5, 1-7 and 1-11, without the reader's exercises.
inline LinkRow reference_row(const Link& link, const std::vector<Body>& bodies,
                             const StepSettings& s) {
  const Body &a = bodies[link.body1], &b = bodies[link.body2];
  const real sign = link.rope ? -1 : 1, C = sign * (length(b.x - a.x) - link.length);
  const Row J = row_by_rates(sign * direction(b.x - a.x), vec3(0), vec3(0));
  return {J, dense_K(to_jacobian(J), a, b)[0][0], (link.rope && C > 0 ? 1 : s.beta) * C / s.h, 0};
}

/// What became of the bodies: six numbers each. A scene has four at most; 0 for those that it has
/// not. Where a step explodes, rounding errors do, too: numbers beyond 1e4 are as good.
constexpr int most_bodies = 4;
inline Numbers filled_up(Numbers numbers) {
  numbers.resize(6 * most_bodies);
  return numbers;
}
inline Numbers numbers_of(const std::vector<Body>& bodies) {
  Numbers out;
  for (const Body& body : bodies)
    for (const vec3& a : {body.v, body.x})
      for (int i = 0; i < 3; ++i) out.push_back(std::clamp(double(a[i]), -1e4, 1e4));
  return filled_up(out);
}
inline std::vector<std::string> step_entries() {
  std::vector<std::string> out;
  for (int body = 0; body < most_bodies; ++body)
    for (const char* entry : {"v.x", "v.y", "v.z", "x.x", "x.y", "x.z"})
      out.push_back("bodies[" + std::to_string(body) + "]." + entry);
  return out;
}

/// The steps of one scene.
inline std::vector<Body> walk(const Scene& scene, const Order& order) {
  std::vector<Body> bodies = scene.bodies;
  const StepSettings& s = scene.settings;
  const std::vector<Link>& links = scene.links;
  for (int step = 0; step < scene.steps; ++step) {
    for (Body& body : bodies) body.v += (body.is_static() ? 0 : s.h) * s.gravity;
    std::vector<LinkRow> rows;
    for (std::size_t k = 0; k < links.size(); ++k)
      rows.push_back(reference_row(links[k], bodies, s));
    for (int n = 0; n < s.iterations; ++n)
      for (const int k : order(int(links.size()), n)) {
        const Link& link = links[std::size_t(k)];
        LinkRow& row = rows[std::size_t(k)];
        Body &one = bodies[link.body1], &two = bodies[link.body2];
        real inverse = row.K;
        invert_symmetric(&inverse, 1);  // of 0 it is 0
        real lambda = -inverse * (row.bias + row_velocity(row.J, one, two));
        if (link.rope) {  // what would push is refused
          const real whole = row.sum + lambda, refused = (std::abs(whole) - whole) / 2;
          row.sum = whole + refused;
          lambda += refused;
        }
        Row response;
        form_responses(&row.J, 1, one, two, &response);
        one.v += lambda * response.v1;  // nothing turns
        two.v += lambda * response.v2;
      }
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].x = bodies[i].x + s.h * bodies[i].v;
  }
  return bodies;
}

inline Numbers walked(const Scene& scene, const Order& order) {
  return numbers_of(walk(scene, order));
}

}  // namespace joints::testing
