// Exercises 1.1 to 1.6: cases drawn over sizes, scales and sides.
#pragma once

#include "tests/01_distance/step_reference.h"
#include "tests/checker/drawn.h"
#include "tests/checker/impulse_cases.h"
#include "tests/checker/push_cases.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

/// \param r1, r2 levers of its ends
inline Jacobian<1> row_of_rod(const Pair& pair, const vec3& r1, const vec3& r2) {
  const vec3 u = pair.body2.x + r2 - pair.body1.x - r1;
  return to_jacobian(row_by_rates(direction(u), r1, r2));
}

/// Centres at any distance; one of its components may be much smaller.
inline Drawn drawn_centres(Draw& d, bool of_K) {
  const Draw::Units u = d.units();
  Pair pair = d.pair(u);
  vec3 apart = d.vector(d.size("distance", u.m * d.scale(5), "m"));
  const int axis = int(2.99 * d.pick());
  apart[axis] *= real(std::pow(10, -5 * d.pick()));
  pair.body2.x = pair.body1.x + apart;
  const Jacobian<1> J = row_of_rod(pair, vec3(0), vec3(0));
  const double K = double(dense_K(J, pair.body1, pair.body2)[0][0]);
  d.size("K", K, "1/kg");
  const CentreDistance rod{real(u.m)};
  if (of_K) return {{"K kg"}, {double(rod.K(pair.body1, pair.body2)) * u.kg}, {K * u.kg}};
  return drawn_rows(to_jacobian(rod.jacobian(pair.body1, pair.body2)), J, u.m, u.m);
}

inline Row drawn_row(Draw& d, const Draw::Units& u) {
  return {d.vector(), d.vector(u.m), d.vector(), d.vector(u.m)};
}

inline Drawn drawn_row_impulse(Draw& d) {
  const Draw::Units u = d.units();
  const Pair pair = d.pair(u);
  const Row J = drawn_row(d, u);
  const double K = double(dense_K(to_jacobian(J), pair.body1, pair.body2)[0][0]);
  const double b = u.m / u.s * d.number();
  const LackCase lack{"", {J}, {real(K)}, {b}, pair};
  const double right = lack.lambda()[0];
  d.size("|J V + b|", lack.rate(0), "m/s");
  d.size("|lambda|", right, "N s");
  d.side("J V is positive", lack.rate(0) > b);
  d.side("lambda is negative", right < 0);
  d.size("K", K, "1/kg");
  return {{"lambda / (kg m/s)"},
          {double(row_impulse(J, real(K), real(b), pair.body1, pair.body2)) * u.s / u.m / u.kg},
          {right * u.s / u.m / u.kg}, {10}};
}

inline Drawn drawn_row_push(Draw& d) {
  const Draw::Units u = d.units();
  PushCase c{"", {}, {}, d.pair(u)};
  c.J = {drawn_row(d, u)};
  c.lambda = {real(d.size("|lambda|", u.kg * u.m / u.s * d.number(), "N s"))};
  d.side("lambda is negative", c.lambda[0] < 0);
  Pair pair = c.pair;
  apply_impulse(c.J[0], c.lambda[0], pair.body1, pair.body2);
  return drawn_vectors({"v1", "w1", "v2", "w2"}, numbers_of(pair), pushed(c),
                       {u.m / u.s, 1 / u.s});
}

/// Bodies in a cloud, links between any two. The reader's other exercises are not asked.
inline Drawn drawn_step(Draw& d, bool ropes) {
  const Draw::Units u = d.units();
  std::vector<Body> bodies(std::size_t(d.count("bodies", d.whole(2, 300))));
  std::vector<Link> links(std::size_t(d.count("links", d.whole(0, 300))));
  const int most = std::min(300, 6000 / (1 + int(links.size())));
  const int iterations = d.count("iterations", d.whole(0, most));
  Random random = d.many();
  bool backward = false;
  for (Body& body : bodies) {
    const vec3 x = real(u.m) * random.vector(4);
    const bool wall = random.uniform(0, 1) < real(0.2);
    body = wall ? static_body(x) : ball(real(u.kg) * random.uniform(1, 3), real(u.m), x);
    if (!wall) body.v = real(u.m / u.s) * random.vector(1);
  }
  const int last = int(bodies.size()) - 1;
  for (Link& link : links) {
    link.body1 = int(random.uniform(0, real(last + 1) - real(1e-3)));
    link.body2 = (link.body1 + 1 + int(random.uniform(0, real(last) - real(1e-3)))) % (last + 1);
    backward = backward || link.body1 > link.body2;
    link.length = length(bodies[link.body2].x - bodies[link.body1].x) +
                  real(0.01 * u.m) * random.uniform(-1, 1);
    link.rope = ropes && random.uniform(0, 1) < real(0.5);
  }
  const StepSettings settings{real(u.m / u.s / u.s) * random.vector(1), real(0.02 * u.s),
                              iterations, real(0.2)};
  d.side("a link has body 1 behind body 2", backward);
  const auto numbers = [&](const std::vector<Body>& now) {
    Numbers out;
    for (std::size_t k = 0; k < now.size(); ++k)
      for (int i = 0; i < 6; ++i)
        out.push_back(double(i < 3 ? now[k].v[i] : (now[k].x - bodies[k].x)[i - 3]) /
                      (i < 3 ? u.m / u.s : 0.02 * u.m));
    return out;
  };
  std::vector<Body> yours = bodies;
  step(yours, links, settings);
  Drawn out{{}, numbers(yours), {}, {20}};
  for (std::size_t k = 0; k < bodies.size(); ++k)
    for (const char* entry : {"v.x", "v.y", "v.z", "h v.x", "h v.y", "h v.z"})
      out.entries.push_back(entry + (" of body " + std::to_string(k)));
  for (const Order& order : right_orders()) {
    const Numbers right = numbers(walk({"", bodies, links, settings}, order));
    const bool same = same_numbers(out.yours, right, 1e-8);
    if (same || out.right.empty()) out.right = right;
    if (same) break;
  }
  return out;
}

inline Drawn drawn_clamp(Draw& d) {
  const double unit = d.scale(12);
  const double before = d.chance("the sum is 0") ? 0 : unit * std::abs(d.number());
  const double dlambda = d.size("|dlambda|", unit * d.any_size(3), "N s");
  d.size("old sum", before, "N s");
  real sum = real(before);
  const double applied = double(clamp_sum(real(dlambda), sum));
  const double whole = before + dlambda, right = (whole + std::abs(whole)) / 2;
  d.size("new sum", right, "N s");
  d.side("dlambda is negative", dlambda < 0);
  d.side("the rope is released", whole < 0);
  return {{"returned / dlambda", "new sum / dlambda"},
          {applied / std::abs(dlambda), double(sum) / std::abs(dlambda)},
          {(right - before) / std::abs(dlambda), right / std::abs(dlambda)},
          {1 + before / std::abs(dlambda)}};
}

/// A rod between anchors, its points as near to each other as rounding lets them be.
inline Drawn drawn_rod(Draw& d, bool of_K) {
  const Draw::Units u = d.units();
  Pair pair = d.pair(u);
  const auto [anchor1, anchor2] = d.levers(u);
  const Distance rod{anchor1, anchor2, real(u.m)};
  const vec3 r1 = to_world(pair.body1, rod.anchor1_local);
  const vec3 r2 = to_world(pair.body2, rod.anchor2_local);
  const double l1 = double(length(r1)), l2 = double(length(r2));
  const double apart = d.size("distance", (l1 + l2) * std::pow(10, -5 * d.pick()), "m");
  pair.body2.x = pair.body1.x + r1 - r2 + d.vector(apart);
  const Jacobian<1> J = row_of_rod(pair, r1, r2);
  if (of_K) return drawn_K(d, to_matrix(rod.K(pair.body1, pair.body2)), J, pair, u.kg);
  return drawn_rows(to_jacobian(rod.jacobian(pair.body1, pair.body2)), J,
                    l1 + 1e-6 * l2, l2 + 1e-6 * l1);
}

}  // namespace joints::testing
