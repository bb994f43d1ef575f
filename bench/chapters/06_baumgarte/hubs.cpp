// Arms about a light hub: where Eq. 6-9 does not hold, because an iteration turns a pattern of
// errors and does not only shorten it.
#include <cmath>

#include "bench/chapters/06_baumgarte/experiments.h"
#include "engine/instruments/rate.h"
#include "joints/ball_joint.h"

namespace joints::chapter6 {

namespace {

// Cubes of 1 kg around a hub, each on a ball, with nothing that acts on them.
World hub_with(int arms, real hub_mass, real beta) {
  World world;
  world.gravity = vec3(0);
  const BodyId hub = world.add(box(hub_mass, vec3(1), vec3(0)));
  for (int k = 0; k < arms; ++k) {  // on a spiral about a sphere
    const double y = 1 - (2 * k + 1.0) / arms, across = std::sqrt(1 - y * y), angle = 2.399963 * k;
    const vec3 out(real(across * std::cos(angle)), real(y), real(across * std::sin(angle)));
    const BodyId arm = world.add(box(1, vec3(1), real(1.5) * out));
    world.add<BallJoint>(hub, arm, real(0.75) * out).beta = beta;
  }
  return world;
}

// The largest speed after nine seconds, of arms that begin with about 1 mm/s.
double speed(World world, int iterations, bool warm) {
  SequentialImpulses solver;
  solver.iterations = iterations;
  const StepOptions how{.warm_start = warm};
  step(world, solver, h, how);
  for (int slot = 1; slot < world.bodies.slots(); ++slot)
    world.bodies.at(slot).v =
        real(1e-3) * vec3(real(std::sin(7.0 * slot - 6)), real(std::cos(3.0 * slot - 3)), 0);
  for (int n = 0; n < steps_in(9, h); ++n) step(world, solver, h, how);
  double top = 0;
  for (const Body& body : world.bodies) top = std::max(top, double(length(body.v)));
  return top;
}

}  // namespace

void hubs(const Choice& choice) {
  CsvFile table(choice.out + "/hubs.csv",
                {"arms", "hub_kg", "rho", "warm_m_s", "cold_m_s"});
  for (const real hub_mass : {real(1), real(0.1)})
    for (const int arms : {6, 12, 40}) {
      World world = hub_with(arms, hub_mass, real(0));
      world.bodies.at(1).v = vec3(real(1e-3), 0, 0);
      const double rho = contraction_rate(world, 400);
      table.row({double(arms), double(hub_mass), rho, speed(hub_with(arms, hub_mass, 0), 10, true),
                 speed(hub_with(arms, hub_mass, real(0.2)), 30, false)});
    }
}

}  // namespace joints::chapter6
