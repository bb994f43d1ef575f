// What the dense matrices of a scene say.
#include "tests/oracle/rigs.h"

#include <cmath>

namespace joints::testing {

double largest_impulse(const World& world) { return impulses(world.blocks).largest(); }

System rows_of(World& world) {
  const Bodies as_it_was = world.bodies;
  SequentialImpulses solver;
  begin_step(world, solver, real(1) / 60);
  world.bodies = as_it_was;
  return system_of(world.blocks, world.bodies.slots());
}

Dense whole_K(const System& system, const World& world) {
  return system.J * inverse_masses(snapshot(world.bodies)) * system.J.transpose();
}

Dense iteration_matrix(const Dense& A, const std::vector<int>& block) {
  Dense L = A;
  for (long i = 0; i < A.rows(); ++i)
    for (long j = 0; j < A.columns(); ++j)
      if (block[std::size_t(j)] > block[std::size_t(i)]) L(i, j) = 0;
  return Dense::identity(A.rows()) - inverse_of(L) * A;
}

double iteration_rate(const World& world, const System& system) {
  const Dense G = iteration_matrix(whole_K(system, world), system.block);
  return spectral_radius(G);
}

}  // namespace joints::testing
