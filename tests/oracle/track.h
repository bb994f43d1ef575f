// Balls on a line with joints along it, where every correction can be worked out in the head, and
// the solver in its three ways to feed an error back.
#pragma once

#include "engine/steps/two_pass_impulses.h"
#include "tests/oracle/oracle.h"

namespace joints::testing {

/// Sequential Impulses with relax iterations. \param first iterations before the bodies move
inline TwoPassImpulses relaxing(int iterations = 1, int first = 10) {
  TwoPassImpulses solver;
  solver.iterations = first;
  solver.relax_iterations = iterations;
  return solver;
}
/// With a split impulse.
inline TwoPassImpulses splitting(int iterations = 1, int first = 10) {
  TwoPassImpulses solver;
  solver.iterations = first;
  solver.split_iterations = iterations;
  return solver;
}
/// With neither.
inline TwoPassImpulses feeding_back(int first = 10) {
  TwoPassImpulses solver;
  solver.iterations = first;
  return solver;
}

/// Holds body 2 `length` beyond body 1 along x, or with `pushes` at least as far.
class Along : public Joint {
 public:
  real length = 1;
  bool pushes = false;
  real rate = 0;  // a target rate beside the position
  mutable real impulse = 0;
  Along(BodyId a, BodyId b, real length, bool pushes = false)
      : Joint(a, b), length(length), pushes(pushes) {}
  void append(const Bodies& bodies, Blocks& blocks) const override {
    RowSettings target = hold(pushes ? real(0) : -unbounded);
    target.rate = rate;
    const real C = bodies[body2].x.x - bodies[body1].x.x - length;
    blocks.append(bodies, body1, body2, Jacobian<1>{{{{vec3(-1, 0, 0), vec3(0), vec3(1, 0, 0),
                                                        vec3(0)}}}}, {C}, target, &impulse);
  }
};

/// Balls on the x axis, the first one static, without gravity.
struct Track {
  World world;
  std::vector<BodyId> ids;
  explicit Track(const std::vector<real>& places, const std::vector<real>& masses) {
    world.gravity = vec3(0);
    for (std::size_t k = 0; k < places.size(); ++k)
      ids.push_back(world.add(k == 0 ? static_body(vec3(places[0], 0, 0))
                                     : ball(masses[k - 1], real(0.1), vec3(places[k], 0, 0))));
  }
  Along& join(int a, int b, real length, bool pushes = false) {
    return world.add<Along>(ids[std::size_t(a)], ids[std::size_t(b)], length, pushes);
  }
  double x(int k) { return double(world.bodies[ids[std::size_t(k)]].x.x); }
  real& v(int k) { return world.bodies[ids[std::size_t(k)]].v.x; }
};

}  // namespace joints::testing
