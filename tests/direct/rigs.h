// What the tests of the direct solver share: mechanisms at random, runs that are watched, and the
// velocities that a dense solve gives.
#pragma once

#include "bench/chapters/09_direct/linkages.h"
#include "direct/direct_solver.h"
#include "joints/distance_joint.h"
#include "joints/slider_joint.h"
#include "tests/oracle/rigs.h"

namespace joints::testing {

inline const StepOptions second_order{.leapfrog = true};
inline constexpr real sixtieth = real(1) / 60;  ///< [s]

/// A direct solver. \param newton iterations on the positions; 0: it corrects velocities alone
inline DirectSolver with(int newton, real added_inertia = 0) {
  DirectSolver solver;
  solver.newton = newton;
  solver.added_inertia = added_inertia;
  return solver;
}
/// One that also corrects the new poses (SHAKE).
inline DirectSolver shake() { return with(8); }

/// All joints of a world feed back all of their error.
inline void feed_back_all(World& world) {
  for (const auto& joint : world.joints()) joint->beta = 1;
}

/// A joint of any kind between two bodies as they stand.
inline void join_at_random(World& world, BodyId id1, BodyId id2, Random& random) {
  const Bodies& bodies = world.bodies;
  const vec3 anchor = (bodies[id1].x + bodies[id2].x) / real(2) + random.vector(real(0.3));
  const vec3 axis = random.vector(1);
  switch (int(random.uniform(0, real(4.999)))) {
    case 0: world.add<BallJoint>(id1, id2, point_at(bodies[id1], bodies[id2], anchor)); break;
    case 1: world.add<HingeJoint>(id1, id2, anchor, axis); break;
    case 2: world.add<SliderJoint>(id1, id2, anchor, axis); break;
    case 3: world.add<FixedJoint>(id1, id2, anchor); break;
    default:
      world.add<DistanceJoint>(
          id1, id2,
          Distance{.anchor2_local = random.vector(real(0.2)),
                   .length = length(bodies[id1].x - bodies[id2].x)});
  }
}

/// Bodies of uneven inertia in any orientation, the first and the last of them static, a tree of
/// joints and `loops` rods more.
inline World mechanism(Random& random, int count, int loops) {
  World world;
  std::vector<BodyId> ids;
  for (int k = 0; k < count; ++k) {
    const vec3 x = random.vector(2);
    const quat q = random.turn();
    const vec3 moments(random.uniform(real(0.2), real(0.3)), random.uniform(real(0.3), real(0.4)),
                       random.uniform(real(0.4), real(0.5)));
    const bool fixed = k == 0 || k + 1 == count;
    ids.push_back(world.add(fixed ? static_body(x, q)
                                  : body_with(random.uniform(1, 3), moments, x, q)));
    if (k > 0)
      join_at_random(world, ids[std::size_t(random.uniform(0, real(k) - real(0.01)))], ids.back(),
                     random);
  }
  for (int k = 0; k < loops; ++k) {
    const std::size_t a = std::size_t(random.uniform(0, real(count) - real(1.01)));
    const vec3 between = world.bodies[ids[a]].x - world.bodies[ids[a + 1]].x;
    world.add<CentreDistanceJoint>(ids[a], ids[a + 1], CentreDistance{length(between)});
  }
  return world;
}

/// Bodies a little away from the poses at which their joints are closed.
inline void displace_at_random(Bodies& bodies, Random& random, real size) {
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    Body& body = bodies.at(slot);
    const vec3 move = random.vector(size), turn = random.vector(size);
    if (body.is_static()) continue;
    body.x += move;
    body.q = normalize(rotation(turn) * body.q);
  }
}

// ---- what is measured ---------------------------------------------------------------------------

/// The greatest gap of a scene's joints now [m].
inline double widest_gap(const Scene& scene) {
  GapMeter meter;
  meter.look(scene.marks, poses(scene.world.bodies));
  return meter.maximum();
}

/// Energy at the poses of `before` [J]: leapfrog has velocities half a step earlier there, and half
/// a step later in `after`.
inline double energy_between(std::vector<Body> before, const std::vector<Body>& after,
                             const vec3& gravity) {
  for (std::size_t k = 0; k < before.size(); ++k) {
    before[k].v = (before[k].v + after[k].v) / real(2);
    before[k].w = (before[k].w + after[k].w) / real(2);
  }
  return energy(before, gravity);
}

/// What a scene did while it ran.
struct Watched {
  double gap = 0;      ///< the greatest [m]
  double highest = 0;  ///< energy over that of the start, at most [energy_scale]
  double change = 0;   ///< largest change of the energy either way [energy_scale]
  bool finite = true;
};

/// Runs a scene by second order steps. \param look called after each step
template <class Look>
Watched watch(Scene& scene, Solver& solver, double seconds, double h, Look look) {
  Watched out;
  double start = 0;
  const int steps = int(std::lround(seconds / h));
  for (int n = 0; n < steps; ++n) {
    const std::vector<Body> before = snapshot(scene.world.bodies);
    step(scene.world, solver, real(h), second_order);
    const std::vector<Body> after = snapshot(scene.world.bodies);
    double now = energy(before, scene.world.gravity);
    if (n > 0) now = energy_between(before, after, scene.world.gravity);
    if (n == 0) start = now;
    out.highest = std::max(out.highest, (now - start) / scene.energy_scale);
    out.change = std::max(out.change, std::abs(now - start) / scene.energy_scale);
    out.gap = std::max(out.gap, widest_gap(scene));
    out.finite = out.finite && all_finite(scene.world);
    look();
    if (!out.finite) break;
  }
  return out;
}
inline Watched watch(Scene& scene, Solver& solver, double seconds, double h) {
  return watch(scene, solver, seconds, h, [] {});
}

}  // namespace joints::testing
