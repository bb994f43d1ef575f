// A chain that falls onto the ground, and a step that solves joints and contacts in one of three
// orders. There is nothing to edit here.
#pragma once

#include <cmath>

#include "chapters/08_ground/program/program.h"
#include "joints/ball_joint.h"

namespace joints::chapter8 {

/// The order of the blocks of joints and contacts in a step.
enum class Turns {
  interleaved,     ///< all blocks in every iteration
  joints_first,    ///< all iterations over the joints, then all iterations over the contacts
  contacts_first,  ///< the reverse
  no_ground        ///< there are no contacts
};

/// One step; in any order, every block is solved in the same number of iterations. It does not add
/// late limits: a corner that a neighbour drives into the ground gets its rows in the next step.
/// \param joint_blocks number of blocks in the list that belong to joints; those of contacts follow
inline void step_in_turns(Scene& scene, int joint_blocks, Turns turns) {
  SequentialImpulses& solver = scene.solver;
  begin_step(scene.world, solver, scene.h, scene.stepping);
  const int all = solver.prepared_count();
  const auto iterations = [&](int from, int to) {
    for (int i = 0; i < solver.iterations; ++i) solver.iterate(scene.world.bodies, from, to);
  };
  const bool apart = turns == Turns::joints_first || turns == Turns::contacts_first;
  if (turns == Turns::contacts_first) iterations(joint_blocks, all);
  iterations(0, apart ? joint_blocks : all);
  if (turns == Turns::joints_first) iterations(joint_blocks, all);
  end_step(scene.world, solver, scene.h, scene.stepping);
}

/// Cubes on ball joints in a row, the first static and high up, released level. The far end hits
/// the ground and is dragged over it.
struct LandingChain {
  Scene scene;               ///< the scene; joints first, then contacts
  std::vector<BodyId> ids;   ///< its cubes, the static one first
  int joint_blocks = 0;      ///< one per joint

  /// Makes the scene. \param links cubes that move
  LandingChain(Turns turns, int links, int iterations, real beta) : scene{.name = "order"} {
    scene.solver.iterations = iterations;
    World& world = scene.world;
    const vec3 size(real(0.4));
    const BodyId ground = add_ground(scene, 12);
    const real height = real(0.5) * real(links) * real(0.5);
    for (int k = 0; k <= links; ++k) {
      const vec3 x(real(0.5) * real(k), height, 0);
      ids.push_back(scene.box(k == 0 ? 0 : 10, size, x));
      if (k == 0) continue;
      const BodyId before = ids[std::size_t(k) - 1];
      const vec3 anchor = x - vec3(real(0.25), 0, 0);
      world.add<BallJoint>(before, ids.back(),
                           anchor)
          .beta = beta;
      scene.mark(before, ids.back(), anchor);
      scene.energy_scale += 10 * 9.81 * 0.5 * k;
      ++joint_blocks;
    }
    if (turns == Turns::no_ground) return;
    for (std::size_t k = 1; k < ids.size(); ++k)
      stand(scene, ground, ids[k], size, real(0.5)).beta = beta;
  }

  /// One step.
  void step(Turns turns) { step_in_turns(scene, joint_blocks, turns); }
};

}  // namespace joints::chapter8
