// Exercise 6.4, the soft step: as a table of chains, and on one joint beside the spring's formula.
#pragma once

#include "tests/06_baumgarte/soft_cases.h"
#include "tests/06_baumgarte/torn_joints.h"

namespace joints::testing {

inline constexpr Subject soft_step_subject{"6.4", "the soft step", 3};
inline const vec3 soft_gravity(real(0.3), real(-9.81), real(0.6));

// ---- chains -------------------------------------------------------------------------------------

struct SoftStepCase {
  std::string words;
  Chain chain;
  std::vector<vec3> impulses;
  SoftStep how;
  double h;
};
inline SoftStepCase soft_step_case(const std::string& words, const SoftStep& how, double rate,
                                   unsigned seed) {
  Random random(seed);
  SoftStepCase c{words, torn_chain({0.02, 0.1, 0.05, 0.1}, true), {}, how, 1 / rate};
  for (Body& body : c.chain.bodies)
    if (!body.is_static()) body.w = random.vector(1);
  for (std::size_t k = 0; k < c.chain.joints.size(); ++k) c.impulses.push_back(random.vector(1));
  return c;
}

/// The step from its parts, which are given.
template <class Row, class Iterate>
void soft_step_of(Row row, Iterate iterate, Chain& chain, std::vector<vec3>& impulses,
                  const SoftStep& how, const vec3& gravity, real h) {
  const real h_sub = h / real(how.substeps);
  for (int left = how.substeps; left > 0; --left) {
    std::vector<JointRows> joints;
    const auto each = [&](auto does) {
      for (std::size_t k = 0; k < joints.size(); ++k)
        does(joints[k], impulses[k], chain.bodies[k], chain.bodies[k + 1]);
    };
    const auto once = [&](const SoftRow& soft) {
      each([&](const JointRows& one, vec3& lambda, Body& a, Body& b) {
        iterate(one, soft, lambda, a, b);
      });
    };
    for (Body& one : chain.bodies) integrate_forces(one, gravity, h_sub);
    joints = rows_of(chain);
    each([](const JointRows& one, const vec3& lambda, Body& a, Body& b) {
      apply_impulse(one.J, lambda, a, b);
    });
    once(row(how.frequency, how.damping, h_sub));
    move(chain, h_sub);
    for (int n = how.relax; n > 0; --n) once({0, 0});
  }
}

inline CaseTable<SoftStepCase> soft_step_table() {
  using Case = SoftStepCase;
  CaseTable<Case> table{soft_step_subject, {}, {}, {}, {}, {}};
  for (int k = 1; k < 5; ++k)
    for (const char* of : {"x", "rotation", "v", "w"})
      for (const char* part : {".x", ".y", ".z"})
        table.entries.push_back(of + (" of body " + std::to_string(k)) + part);
  for (int k = 0; k < 4; ++k)
    for (const char* part : {".x", ".y", ".z"})
      table.entries.push_back("impulse of joint " + std::to_string(k) + part);
  table.whole = true;
  table.cases = {
      soft_step_case("1 substep, 1 relax", {20, real(0.7), 1, 1}, 60, 651),
      soft_step_case("1 substep, no relax", {20, real(0.7), 1, 0}, 60, 652),
      soft_step_case("3 substeps, 1 relax", {30, 2, 3, 1}, 50, 653),
      soft_step_case("4 substeps, 2 relax", {60, 1, 4, 2}, 72.5, 654)};
  const auto numbers = [](auto advance, const Case& c) {
    Chain chain = c.chain;
    std::vector<vec3> impulses = c.impulses, all;
    advance(chain, impulses, c.how, soft_gravity, real(c.h));
    for (std::size_t k = 1; k < chain.bodies.size(); ++k) {
      const Body &body = chain.bodies[k], &before = c.chain.bodies[k];
      all.insert(all.end(), {body.x, turn_between(before.q, body.q), body.v, body.w});
    }
    all.insert(all.end(), impulses.begin(), impulses.end());
    return flat(all);
  };
  judge(table, soft_step, numbers);
  const auto of_parts = [=](auto row, auto iterate) {
    return [=](const Case& c) {
      return numbers([=](Chain& chain, std::vector<vec3>& impulses, const SoftStep& how,
                         const vec3& gravity, real h) {
        soft_step_of(row, iterate, chain, impulses, how, gravity, h);
      }, c);
    };
  };
  const auto right_row = [](real frequency, real damping, real h) {
    const Numbers row = spring_at_the_end(double(frequency), double(damping), double(h));
    return SoftRow{real(row[0]), real(row[1])};
  };
  const auto right_iteration = [](const JointRows& rows, const SoftRow& soft, vec3& lambda,
                                  Body& a, Body& b) {
    const vec3 change = right_soft_change({"", rows, soft, lambda, {a, b}});
    apply_impulse(rows.J, change, a, b);
    lambda += change;
  };
  table.right = of_parts(right_row, right_iteration);
  table.mistakes.put_first({"the step is right and its parts are not: look at `soft_row` and at "
                            "`soft_iteration`, the first parts of the exercise",
                            of_parts(soft_row, soft_iteration)});
  table.tolerance = difference_tolerance;
  return table;
}

// ---- one joint: the formula of its spring -------------------------------------------------------

/// A body on one soft joint at its centre, its gap, and how it moves.
struct Hanging {
  SoftStep how;
  double h = 1.0 / 60;  ///< the whole step
  vec3 gap{0}, v{0}, gravity{0};
  real mass = 2;
};

/// The gaps after each of some steps.
inline std::vector<vec3> gaps_of(const Hanging& hanging, int steps) {
  Chain chain{{static_body(vec3(0)), body_with(hanging.mass, vec3(1), hanging.gap)},
              {Point{vec3(0), vec3(0)}}};
  chain.bodies[1].v = hanging.v;
  std::vector<vec3> impulses(1, vec3(0)), out;
  for (int n = 0; n < steps; ++n) {
    soft_step(chain, impulses, hanging.how, hanging.gravity, real(hanging.h));
    out.push_back(chain.bodies[1].x);
  }
  return out;
}

/// A gap after n substeps by the formula of an implicit spring. \param a its acceleration
inline double gap_by_formula(const Hanging& of, int n, double gap, double v, double a) {
  const double omega = 2 * std::numbers::pi * double(of.how.frequency);
  const double zeta = double(of.how.damping), h = of.h / of.how.substeps, turn = h * omega;
  const double all = 1 + 2 * zeta * turn + turn * turn, rest = a / (omega * omega);
  const double first = ((1 + 2 * zeta * turn) * (gap - rest) + h * v) / all;
  if (of.how.relax > 0) return rest + first * std::pow((1 + 2 * zeta * turn) / all, n - 1);
  // the roots are size exp(+- i angle)
  const double size = 1 / std::sqrt(all);
  const double angle = std::atan2(turn * std::sqrt(1 - zeta * zeta), 1 + zeta * turn);
  const double sine = (first / size - (gap - rest) * std::cos(angle)) / std::sin(angle);
  return rest + std::pow(size, n) * ((gap - rest) * std::cos(n * angle) +
                                     sine * std::sin(n * angle));
}

/// Frequency [Hz] and loss of energy per step of gaps that swing about zero.
inline std::pair<double, double> frequency_and_loss(const std::vector<vec3>& gaps, double h) {
  double x[4];  // two steps are enough: x[k + 2] = p x[k + 1] - q x[k]
  for (int k = 0; k < 4; ++k) x[k] = double(gaps[std::size_t(k)].x);
  const double det = x[0] * x[2] - x[1] * x[1];
  const double p = (x[0] * x[3] - x[1] * x[2]) / det, q = (x[1] * x[3] - x[2] * x[2]) / det;
  return {std::acos(p / (2 * std::sqrt(q))) / (2 * std::numbers::pi * h), 1 - q};
}

/// One joint, with any settings.
inline Drawn drawn_soft_step(Draw& d) {
  const int substeps = d.count("substeps", d.whole(1, 30));
  const int relax = d.count("relax iterations", d.whole(0, 3));
  const int steps = d.count("steps", d.whole(1, 10));
  const double h = d.size("h", d.scale(6), "s");
  const double turn = std::pow(10, 1 - 2 * d.pick()), zeta = d.pick() * (relax > 0 ? 5 : 0.9);
  d.size("h omega of a substep", turn, "");
  d.size("damping", zeta, "");
  Hanging one{{real(turn * substeps / (2 * std::numbers::pi * h)), real(zeta), substeps, relax}, h,
              d.vector(), vec3(0), vec3(0), 2};
  if (d.chance("it moves at first")) one.v = d.vector(substeps / h);
  const double omega = turn * substeps / h;
  if (d.chance("there is gravity")) one.gravity = d.vector(omega * omega);
  const vec3 gap = gaps_of(one, steps).back();
  Drawn out{{"gap.x", "gap.y", "gap.z"}, {}, {}, {10}};
  for (int i = 0; i < 3; ++i) {
    out.yours.push_back(double(gap[i]));
    out.right.push_back(gap_by_formula(one, steps * substeps, double(one.gap[i]),
                                       double(one.v[i]), double(one.gravity[i])));
  }
  return out;
}

/// The two numbers of a soft row at any frequency.
inline Drawn drawn_soft_row(Draw& d) {
  const double h = d.size("h", d.scale(), "s"), turn = d.scale(3);
  const double damping = d.chance("damping is 0") ? 0 : d.size("damping", d.scale(3), "");
  d.size("h omega", turn, "");
  const double frequency = d.size("f", turn / (2 * std::numbers::pi * h), "Hz");
  const SoftRow soft = soft_row(real(frequency), real(damping), real(h));
  const Numbers right = spring_at_the_end(turn / (2 * std::numbers::pi), damping, 1);
  return {{"h rate", "softness"}, {h * double(soft.rate), double(soft.softness)}, right, {}};
}

/// An iteration of a soft block in any units.
inline Drawn drawn_soft_iteration(Draw& d) {
  const Draw::Units u = d.units();
  Pair pair = d.pair(u);
  if (pair.body1.is_static()) pair.body2 = d.body(u);
  const vec3 lever1 = d.vector(u.m);
  const Jacobian<3> J = point_by_rates(lever1, d.vector(u.m));
  const mat3 K = K_of(J, pair);
  const vec3 lambda = d.vector(u.kg * u.m / u.s);
  SoftRow soft{real(d.size("rate", 1 / u.s, "1/s")), 0};
  const bool hard = d.chance("it is hard");
  if (!hard) soft.softness = real(d.size("softness", d.scale(4), ""));
  if (d.chance("there is no bias")) soft.rate = 0;
  const SoftCase c{"", {J, K, d.vector(u.m)}, soft, lambda, pair};
  const vec3 change = right_soft_change(c);
  const Moves a = response<3>(J, to_vector(change), pair);
  vec3 kept = lambda;
  Pair after = pair;
  soft_iteration(c.rows, soft, kept, after.body1, after.body2);
  Drawn out = drawn_vectors({"lambda", "change of v1", "change of w1", "change of v2",
                             "change of w2"},
                            flat({kept, after.body1.v - pair.body1.v, after.body1.w - pair.body1.w,
                                  after.body2.v - pair.body2.v, after.body2.w - pair.body2.w}),
                            flat({lambda + change, a.way1, a.turn1, a.way2, a.turn2}),
                            {u.kg * u.m / u.s, u.m / u.s, 1 / u.s, u.m / u.s, 1 / u.s});
  out.sizes = {200};
  return out;
}

}  // namespace joints::testing
