// Trees drawn at random: sizes, masses, poses, joints and roots of all kinds.
#pragma once

#include "joints/driven_joints.h"
#include "joints/fixed_joint.h"
#include "reduced/reduced.h"
#include "tests/oracle/rigs.h"

namespace joints::testing {

/// What a tree hangs on.
enum class Root { is_static, is_kinematic, is_free };

/// How trees are drawn.
struct TreeFamily {
  int joints = 10;       ///< number of joints
  Root root = Root::is_static;
  real size = 1;         ///< of a body [m]
  real mass = 1;         ///< of a body, within a factor of 3 [kg]
  real speed = 1;        ///< largest component of an angular velocity [rad/s]
  bool six = true;       ///< also joints with six degrees of freedom
  int reach = 3;         ///< a body hangs on one of so many bodies before it: 1 for a chain
};

/// A body of uneven inertia.
inline Body uneven_body(Random& random, const TreeFamily& family, const vec3& x) {
  const real m = family.mass * std::exp2(random.uniform(real(-1.6), real(1.6)));
  const real s = family.size * std::exp2(random.uniform(real(-0.5), real(0.5)));
  const vec3 moments(random.uniform(real(0.05), real(0.07)), random.uniform(real(0.07), real(0.1)),
                     random.uniform(real(0.1), real(0.12)));
  return body_with(m, m * s * s * moments, x, random.turn());
}

/// Joins two bodies as they stand by a joint of any kind.
inline void join_in_tree(World& world, BodyId a, BodyId b, Random& random,
                         const TreeFamily& family) {
  const vec3 anchor = (world.bodies[a].x + world.bodies[b].x) / real(2) +
                      random.vector(real(0.2) * family.size);
  const vec3 axis = normalize(random.vector(1) + vec3(0, 0, real(1.1)));
  const vec3 across = normalize(cross(axis, random.vector(1) + vec3(real(1.2), 0, 0)));
  switch (int(random.uniform(0, family.six ? real(7.99) : real(5.99)))) {
    case 0:
    case 1: world.add<HingeJoint>(a, b, anchor, axis); break;
    case 2: world.add<BallJoint>(a, b, anchor); break;
    case 3: world.add<SliderJoint>(a, b, anchor, axis); break;
    case 4: world.add<FixedJoint>(a, b, anchor); break;
    case 5: world.add<UniversalJoint>(a, b, anchor, axis, across); break;
    default: {  // one displacement and one rotation are free
      auto& six = world.add<SixDofJoint>(a, b, anchor, axis, across);
      six.slide1().set_limits(0, 0), six.slide3().set_limits(0, 0);
      six.twist().set_limits(0, 0), six.swing3().set_limits(0, 0);
    }
  }
}

/// Draws a tree; its first body is the root.
inline World drawn_tree(Random& random, const TreeFamily& family) {
  World world;
  std::vector<BodyId> ids;
  for (int k = 0; k <= family.joints; ++k) {
    const int before = std::max(0, k - 1 - int(random.uniform(0, real(family.reach) - real(0.01))));
    const vec3 x = k == 0 ? random.vector(family.size)
                          : world.bodies[ids[before]].x + random.vector(family.size);
    Body body = uneven_body(random, family, x);
    if (k == 0 && family.root != Root::is_free) body = static_body(x, body.q);
    body.kinematic = k == 0 && family.root == Root::is_kinematic;
    if (k > 0 || family.root != Root::is_static) {
      body.w = random.vector(family.speed);
      body.v = random.vector(family.speed * family.size);
    }
    ids.push_back(world.add(body));
    if (k == 0) continue;
    const bool forward = random.uniform(0, 1) < real(0.6);
    join_in_tree(world, forward ? ids[before] : ids[k], forward ? ids[k] : ids[before], random,
                 family);
  }
  return world;
}

/// A family of any size and mass.
inline TreeFamily any_family(Random& random, int most_joints) {
  TreeFamily family;
  family.joints = int(2 * std::pow(real(most_joints) / 2 + real(0.01), random.uniform(0, 1)));
  family.root = Root(int(random.uniform(0, real(2.99))));
  family.size = std::pow(real(10), random.uniform(-3, 1));
  family.mass = std::pow(real(10), random.uniform(-4, 4));
  family.reach = 1 + int(random.uniform(0, real(3.99)));
  return family;
}

/// The blocks of all joints that hold a position, at any poses.
inline Blocks rows_at(const World& world, const Bodies& bodies) {
  Blocks blocks;
  for (const auto& joint : world.joints()) joint->append(bodies, blocks);
  return blocks;
}

/// J V at the poses that the present velocities lead to.
inline Column rates_after(const World& world, real time) {
  Bodies bodies = world.bodies;
  for (Body& body : bodies) {
    body.x += time * body.v;
    body.q = normalize(rotation(time * body.w) * body.q);
  }
  return system_of(rows_at(world, bodies), bodies.slots()).J * velocities(snapshot(bodies));
}

/// The accelerations that the rows determine: J a = -(dJ/dt) V, M a = forces + J^T lambda.
inline Column accelerations_of_rows(World& world, real speed) {
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, real(1e-3));
  const System system = system_of(rows_at(world, world.bodies), world.bodies.slots());
  const std::vector<Body> bodies = snapshot(world.bodies);
  const Dense W = inverse_masses(bodies);
  Column free(6 * long(bodies.size()));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].is_static()) continue;
    const dmat3 I = inertia_of(bodies[k]);
    const dvec3 w(bodies[k].w), spin = glm::inverse(I) * (dvec3(bodies[k].torque) -
                                                         glm::cross(w, I * w));
    const dvec3 a = dvec3(world.gravity) + double(bodies[k].inverse_mass) * dvec3(bodies[k].force);
    for (int i = 0; i < 3; ++i) free[6 * long(k) + i] = a[i], free[6 * long(k) + 3 + i] = spin[i];
  }
  const real e = real(1e-3) / speed;
  const Column change = (8.0 * (rates_after(world, e) - rates_after(world, -e)) -
                         (rates_after(world, 2 * e) - rates_after(world, -2 * e))) /
                        (12 * double(e));
  Dense K = system.J * W * system.J.transpose();
  Column right = -change - system.J * free;
  std::vector<double> scale;
  for (long i = 0; i < K.rows(); ++i) scale.push_back(1 / std::sqrt(K(i, i)));
  for (long i = 0; i < K.rows(); ++i) {
    right[i] *= scale[i];
    for (long j = 0; j < K.rows(); ++j) K(i, j) *= scale[i] * scale[j];
  }
  Column lambda = solved(K, right);
  const Column left = right - K * lambda;  // one iteration of refinement
  lambda += solved(K, left);
  for (long i = 0; i < K.rows(); ++i) lambda[i] *= scale[i];
  return free + W * system.J.transpose() * lambda;
}

}  // namespace joints::testing
