// Exercises 9.2 to 9.8: cases drawn over sizes, scales and sides.
#pragma once

#include "tests/09_direct/factor_cases.h"
#include "tests/09_direct/newton_cases.h"
#include "tests/09_direct/pivot_cases.h"
#include "tests/09_direct/side_cases.h"
#include "tests/09_direct/slowed_cases.h"
#include "tests/09_direct/solve_cases.h"
#include "tests/09_direct/time_cases.h"
#include "tests/checker/drawn.h"

namespace joints::testing {

/// Edges of a graph: a chain of which each node may be left out, a few more, and a hub.
inline std::vector<std::pair<int, int>> drawn_edges(Draw& d, int nodes, int most_of_hub = 20,
                                                    int most_more = 120) {
  std::set<std::pair<int, int>> edges;
  const int more = d.whole(0, std::min(nodes, most_more));
  d.side("there are edges beside a chain's", more > 0);
  const int hub = d.count("neighbours of a hub", std::min(nodes - 1, d.whole(0, most_of_hub)));
  Random random = d.many();
  const auto any = [&] { return int(random.uniform(0, real(nodes) - real(0.01))); };
  for (int k = 0; k + 1 < nodes; ++k)
    if (random.uniform(0, 1) < real(0.9)) edges.insert({k, k + 1});
  for (int k = 0; k < more; ++k)
    if (const int a = any(), b = any(); a != b) edges.insert({std::min(a, b), std::max(a, b)});
  const int centre = any();
  for (int k = 1; k <= hub; ++k) {
    const int other = (centre + k) % nodes;
    edges.insert({std::min(centre, other), std::max(centre, other)});
  }
  return {edges.begin(), edges.end()};
}

/// A matrix of the joints, and the same in other units: A / unit is of order 1.
inline MatrixCase drawn_matrix(Draw& d) {
  MatrixCase c;
  const double unit = d.size("K", d.scale(), "1/kg");
  const bool full = d.chance("all nodes are neighbours, of six rows");
  c.rows.resize(std::size_t(d.count("nodes", d.whole(1, full ? 60 : 120))));
  const int most = d.count("rows of a node, at most", full ? 6 : d.whole(1, 6));
  if (!full) c.coupled = drawn_edges(d, c.count());
  for (int a = 0; full && a < c.count(); ++a)
    for (int b = a + 1; b < c.count(); ++b) c.coupled.push_back({a, b});
  Random random = d.many();
  for (int& rows : c.rows)
    rows = full ? 6 : 1 + int(random.uniform(0, real(most) - real(0.01)));
  c = filled(c, unsigned(random.uniform(1, 1000)));
  for (double& a : c.A.a) a *= unit;
  const std::vector<Node> nodes = joint_matrix(c).nodes;
  int edges = 0;
  for (std::size_t k = 1; k < nodes.size(); ++k)
    edges = std::max(edges, nodes[k].first_edge - nodes[k - 1].first_edge);
  d.count("edges of a node, with fill", edges);
  d.count("numbers in L", nodes.back().diagonal);
  return c;
}

/// The wrong numbers of a factor alone: there may be ten thousands.
inline Drawn drawn_factor(Draw& d) {
  const MatrixCase c = drawn_matrix(d);
  JointMatrix A = joint_matrix(c);
  factor(A, c.inverse);
  const Numbers yours = flat(A), right = flat(right_factor(c));
  std::vector<std::string> names;
  Drawn out{{""}, {0}, {0}, {1}};
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (near(yours[i], right[i], 1e-9 * (1 + std::abs(right[i])))) continue;
    if (names.empty()) names = factor_names(c), out.entries.clear(), out.yours = out.right = {};
    out.entries.push_back(names[i]);
    out.yours.push_back(yours[i]);
    out.right.push_back(right[i]);
  }
  return out;
}

/// Instead of x: A x beside b.
inline Drawn drawn_solve(Draw& d) {
  const MatrixCase c = drawn_matrix(d);
  const double size = d.size("b", d.scale(12), "m/s");
  d.size("b / K", size / c.A(0, 0), "N s");
  Random random = d.many();
  Numbers b, x;
  for (int i = 0; i < c.size(); ++i) b.push_back(size * double(random.uniform(1, 3)));
  x = b;
  x.resize(b.size() + 8, 0);
  solve(right_factor(c), x.data());
  Drawn out{{}, Numbers(b.size(), 0), b, {size}};
  for (int i = 0; i < c.size(); ++i) {
    for (int j = 0; j < c.size(); ++j) out.yours[std::size_t(i)] += c.A(i, j) * x[std::size_t(j)];
    out.entries.push_back("A x, row " + std::to_string(i) + " (node " +
                          std::to_string(node_of(c, i)) + ")");
  }
  return out;
}

/// The rows of a machine, some of which depend on others before them, and the last independent
/// one nearly: A = J J^T is eliminated with the rule of the reader.
inline Drawn drawn_pivots(Draw& d) {
  const double unit = d.size("K", d.scale(25), "1/kg");
  const int independent = d.count("independent rows", d.whole(1, 24));
  const int n = independent + d.count("dependent rows", d.whole(0, 8));
  const double share = d.size("least pivot over its entry", std::pow(least_pivot, d.pick()), "");
  Random random = d.many();
  std::vector<Numbers> J;
  Drawn out{{}, {}, {}, {1}};
  for (int i = 0, found = 0; i < n; ++i) {
    const bool depends = found == independent ||
                         (i > 0 && n - i > independent - found && random.uniform(0, 1) < real(0.5));
    Numbers row(std::size_t(independent), 0);
    double square = 0;
    for (int k = 0; k < found && !depends; ++k)
      row[std::size_t(k)] = double(random.uniform(-1, 1)), square += row[k] * row[k];
    for (int k = 0; k < i && depends; ++k) {
      if (J[k][independent - 1] != 0 || out.right[std::size_t(k)] == 0) continue;
      const double part = double(random.uniform(-1, 1));
      for (int column = 0; column < independent; ++column) row[column] += part * J[k][column];
    }
    const double left = found + 1 == independent ? std::min(0.5, 1.01 * share) : 1;
    if (!depends) row[found] = std::sqrt(left == 1 ? 1 : left * square / (1 - left));
    if (!depends && row[found] == 0) row[found] = 1;
    found += !depends;
    J.push_back(row);
    out.right.push_back(!depends);
    out.entries.push_back("row " + std::to_string(i) + ": pivot times inverse");
  }
  std::vector<Numbers> A(std::size_t(n), Numbers(std::size_t(n), 0));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < independent; ++k) A[i][j] += unit * J[i][k] * J[j][k];
  const std::vector<Numbers> original = A;
  for (int k = 0; k < n; ++k) {
    const double inverse = inverse_pivot(A[k][k], original[k][k]);
    out.yours.push_back(A[k][k] * inverse);
    for (int i = k + 1; i < n; ++i)
      for (int j = k + 1; j < n; ++j) A[i][j] -= A[i][k] * inverse * A[k][j];
  }
  return out;
}

inline Drawn drawn_side(Draw& d) {
  const double unit = d.scale(15), infinite = std::numeric_limits<double>::infinity();
  const Side sides[] = {Side::free, Side::lower, Side::upper};
  const Side now = sides[int(2.99 * d.pick())];
  d.side("the row is at its lower bound", now == Side::lower);
  d.side("the row is at its upper bound", now == Side::upper);
  const bool contact = d.chance("the upper bound is infinite");
  const double lower = contact ? 0 : unit * d.number();
  const double upper = contact ? infinite : lower + unit * std::abs(d.number());
  const double beyond = d.size("distance to a bound", unit * std::pow(10, -3 * d.pick()), "N s");
  const bool above = !contact && d.chance("the impulse is near the upper bound");
  const double impulse = (above ? upper : lower) + (d.number() < 0 ? -beyond : beyond);
  const double rate = d.size("|rate|", d.any_size(15), "m/s");
  d.side("the row is free and beyond a bound",
         now == Side::free && (impulse < lower || impulse > upper));
  d.side("the row is free and within its bounds",
         now == Side::free && impulse > lower && impulse < upper);
  d.side("the rate is negative", rate < 0);
  const Side beyond_bounds = sides[impulse > upper ? 2 : impulse < lower];
  const bool leaves = now == Side::lower ? rate < 0 : rate > 0;
  const Side right = now == Side::free ? beyond_bounds : leaves ? Side::free : now;
  const Side yours = next_side(now, impulse, lower, upper, rate);
  return {{"side (-1 lower, 0 free, 1 upper)"}, {double(static_cast<signed char>(yours))},
          {double(static_cast<signed char>(right))}, {1}};
}

inline Drawn drawn_slowed(Draw& d) {
  const Draw::Units u = d.units(12);
  SlowedCase c{"", d.body(u), vec3(0), vec3(0), 8, real(0.01 * u.s)};
  const double inertia = d.size("inertia", u.kg * u.m * u.m, "kg m^2");
  const double thin = d.chance("it is a thin rod") ? std::pow(10, is_float ? 2 : 6 * d.pick()) : 1;
  c.body.inverse_inertia_local[int(2.99 * d.pick())] *= real(d.size("I / I", thin, ""));
  c.kappa = real(8 * d.scale(is_float ? 1 : 5));
  const bool slowed_before = d.chance("the last step slowed it, too");
  for (int k = 0; k < 3; ++k) {
    c.force_lever[k] = real(inertia * d.scale(is_float ? 1 : 12)) / (c.kappa * c.h * c.h);
    if (slowed_before) c.before[k] = real(inertia * d.scale(1));
  }
  if (d.chance("nothing opposes one rotation")) c.force_lever[int(2.99 * d.pick())] = 0;
  const auto largest = [](const vec3& a) { return double(std::max({a.x, a.y, a.z})); };
  d.size("force_lever", largest(c.force_lever), "N m");
  d.size("before", largest(c.before), "kg m^2");
  const vec3 own = real(1) / c.body.inverse_inertia_local, pull = followed(c);
  d.size("needed moment", largest(pull), "kg m^2");
  d.size("needed moment over the own", largest(pull / own), "");
  d.side("no moment grows", largest(pull / own) < 1);
  d.size("last moment over the needed one", largest(c.before) / largest(pull), "");
  const Slowed out = slowed(c.body, c.force_lever, c.before, c.kappa, c.h);
  return drawn_vectors({"1 / moment", "w"},
                       flat(std::vector<vec3>{out.inverse_inertia_local, out.w}),
                       right_slowed(c), {10 / inertia, 1 / u.s});
}

/// A chain of bodies whose joints are balls, and hinges beyond their limit.
inline Drawn drawn_time(Draw& d) {
  const Draw::Units u = d.units(6);
  const int bodies = d.count("bodies", d.whole(1, 30));
  const int joints = d.count("joints", std::min(bodies, d.whole(0, 30)));
  const bool moves = d.chance("the body in slot 0 can move");
  const vec3 gravity = d.vector(u.m / u.s / u.s);
  Random random = d.many();
  TimeCase c{"", [&](World& world) {
               Random numbers = random;
               world.gravity = gravity;
               BodyId last = world.add(moves ? ball(real(u.kg), real(u.m), vec3(0))
                                             : static_body(vec3(0)));
               for (int k = 1; k <= bodies; ++k) {
                 const double square = 0.1 * u.kg * u.m * u.m;
                 Body body = body_with(real(u.kg), real(square) * vec3(2, 5, 6),
                                       real(u.m) * vec3(real(k), 0, 0), numbers.turn());
                 body.v = real(u.m / u.s) * numbers.vector(real(0.1));
                 body.w = real(1 / u.s) * numbers.vector(1);
                 const BodyId id = world.add(body);
                 const vec3 anchor = real(u.m) * vec3(real(k) - real(0.5), 0, 0);
                 if (k <= joints && k % 2)
                   world.add<BallJoint>(last, id,
                                        point_at(world.bodies[last], world.bodies[id], anchor));
                 else if (k <= joints)
                   world.add<HingeJoint>(last, id, anchor, numbers.vector(1))
                       .set_limits(real(0.2), 3);  // that presses from the first step on
                 last = id;
               }
             }, {}};
  for (int n = 0; n < 3; ++n) {
    const double step = 0.02 * u.s * d.scale(1);
    c.steps.push_back(real(step * std::abs(d.number())));
  }
  const auto run = [&](const auto& advance) {
    World world;
    c.build(world);
    SequentialImpulses solver;
    solver.iterations = 12;
    for (const real h : c.steps) advance(world, solver, h);
    Numbers out;
    for (int k = 0; k < world.bodies.slots(); ++k) {
      const Body& b = world.bodies.at(k);
      for (const vec3& a : {real(1 / u.m) * b.x, real(u.s / u.m) * b.v, real(u.s) * b.w})
        for (int i = 0; i < 3; ++i) out.push_back(double(a[i]));
    }
    return out;
  };
  // The engine's own step solves again where a blow changes a fast rotation. Whoever calls it is
  // told so by another test.
  const StepOptions how{.leapfrog = true};
  const Numbers yours = run(second_order_step);
  const Numbers engine = run([&](World& world, Solver& solver, real h) {
    step(world, solver, h, how);
  });
  const Numbers once = run([&](World& world, Solver& solver, real h) {
    begin_step(world, solver, h, how);
    solver.solve(world.bodies);
    end_step(world, solver, h, how);
  });
  Drawn out{{}, yours, yours == engine ? engine : once, {100}};
  for (int k = 0; k <= bodies; ++k)
    for (const char* of : {"x.x", "x.y", "x.z", "v.x", "v.y", "v.z", "w.x", "w.y", "w.z"})
      out.entries.push_back(of + (" of body " + std::to_string(k)));
  return out;
}

/// Bodies that slide to their marks along all three axes: of each change a part arrives.
class Marks : public Corrector {
 public:
  Marks(Bodies& bodies, int first, std::vector<double> marks, double part)
      : bodies_(bodies), first_(first), marks_(std::move(marks)), part_(part) {}
  int asked = 0;
  double last = 0;  ///< largest error of the last change [m]
  std::vector<double>& errors() override {
    ++asked;
    C_.clear();
    for (std::size_t k = 0; k < marks_.size(); ++k)
      C_.push_back(double(bodies_.at(first_ + int(k / 3)).x[int(k % 3)]) - marks_[k]);
    return C_;
  }
  void change_rates(std::vector<double>& rates) override {
    rates.resize(marks_.size(), 0);
    last = 0;
    for (std::size_t k = 0; k < marks_.size(); ++k) {
      Body& body = bodies_.at(first_ + int(k / 3));
      last = std::max(last, std::abs(double(body.x[int(k % 3)]) - marks_[k]));
      body.v[int(k % 3)] += real(part_ * rates[k]);
    }
  }

 private:
  Bodies& bodies_;
  int first_;  ///< slot
  std::vector<double> marks_, C_;
  double part_;
};

inline Drawn drawn_newton(Draw& d) {
  const int slots = d.count("bodies", d.whole(1, 40));
  const int first = d.chance("a body was removed and has left an empty slot");
  const int rows = d.count("rows", std::min(3 * slots, d.whole(1, 120)));
  const int iterations = d.count("iterations", d.whole(0, 40));
  const double unit = d.scale();
  const double h = d.size("h", d.scale(6), "s");
  const bool hardly = d.chance("the error becomes less by nearly the poorest allowed factor");
  double beside = std::pow(10, -1 - 8 * d.pick());
  const double factor = 1 + (d.number() < 0 ? -beside : beside);
  const double part = hardly ? 0.3 * factor : 0.2 + 0.79 * d.pick();
  double tolerance = std::pow(10, -1 - 10 * d.pick());
  Random random = d.many();
  std::vector<double> marks;
  double largest = 0;
  for (int k = 0; k < rows; ++k) {  // the later the row, the farther its mark
    marks.push_back(unit * double(random.uniform(1, 2)) * (1 + 0.1 * k) * (k % 2 ? -1 : 1));
    largest = std::max(largest, std::abs(marks.back()));
  }
  if (d.chance("an error is nearly the tolerance"))
    tolerance = std::pow(1 - part, d.whole(0, 3)) * factor;
  else if (!hardly) beside = 1;
  d.size("distance to a bound / bound", beside, "");
  d.size("tolerance over the first error", tolerance, "");
  d.size("tolerance", tolerance *= largest, "m");
  d.size("first error", largest, "m");
  d.size("first change of the rates", largest / h, "m/s");
  double last = 0;
  const auto run = [&](const auto& move) {
    Bodies bodies;
    const BodyId spare = first ? bodies.add(sliding(0, 0)) : BodyId{};
    for (int k = 0; k < slots; ++k) bodies.add(sliding(0, 0));
    if (first) bodies.remove(spare);
    Marks corrector(bodies, first, marks, part);
    std::vector<Body> start;
    const bool arrived = move(bodies, h, iterations, tolerance, corrector, start);
    last = corrector.last;
    Numbers out{double(arrived), double(corrector.asked)};
    for (int k = 0; k < slots; ++k)
      for (int i = 0; i < 3; ++i) {
        out.push_back(double(bodies.at(first + k).x[i]) / unit);
        out.push_back(double(bodies.at(first + k).v[i]) * h / unit);
      }
    return out;
  };
  Drawn out{{"result (0 false, 1 true)", "calls of errors()"},
            run(move_onto_constraints), {}, {20}};
  out.right = run(right_move);
  d.size("error of the last correction", last, "m");
  for (int k = 0; k < slots; ++k)
    for (const char* of : {"x.x", "h v.x", "x.y", "h v.y", "x.z", "h v.z"})
      out.entries.push_back(of + (" of body " + std::to_string(k)));
  return out;
}

}  // namespace joints::testing
