// Chapter 6: Baumgarte. Replace each todo(...) by your own code; the text is in README.md.
#include "chapters/06_baumgarte/baumgarte.h"

#include "engine/instruments/todo.h"

namespace joints {

// ---- an error fed back as a velocity -----------------------------------------------------------

real bias(real C, real beta, real h) {
  // begin [exercise 6.1]
  // Return b of Eq. 6-2.
  todo("6.1");
  // end [exercise 6.1]
}

real limit_bias(real C, real beta, real h) {
  // begin [exercise 6.1]
  // Return b of Eq. 6-5: one case for a violated limit, one for a limit not yet reached.
  todo("6.1");
  // end [exercise 6.1]
}

real beta_for(real half_time, real h) {
  // begin [exercise 6.1]
  // Return beta of Eq. 6-4. std::exp2(x) is 2 to the power x.
  todo("6.1");
  // end [exercise 6.1]
}

// ---- beginning with the impulses of the last step ----------------------------------------------

void warm_start(const Jacobian<3>& J, real ratio, vec3& lambda, Body& body1, Body& body2) {
  // begin [exercise 6.2]
  // Scale lambda by Eq. 6-8 and apply it to the bodies with apply_impulse of exercise 2.3. The
  // iterations continue from lambda, so it must equal the impulse that has been applied.
  todo("6.2");
  // end [exercise 6.2]
}

bool warm_start_is_safe(real rho, int iterations, real beta) {
  // begin [exercise 6.2]
  // Return true if Eq. 6-9 holds. std::pow(x, n) is x to the power n.
  todo("6.2");
  // end [exercise 6.2]
}

// ---- position projection -----------------------------------------------------------------------

void project(const Point& point, Body& body1, Body& body2) {
  // begin [exercise 6.3]
  // Compute lambda of Eq. 6-10 from the error and K of the point, at the present poses. The
  // displacements of Eq. 6-11 are M^-1 J^T lambda, and apply_impulse of exercise 2.3 adds just this
  // to velocities. So copy both bodies, set v and w of the copies to zero, and apply lambda to the
  // copies: their v and w are then the displacements. turned(q, w, 1) rotates q by w [rad].
  todo("6.3");
  // end [exercise 6.3]
}

void project(const Rope<Distance>& rope, Body& body1, Body& body2) {
  // begin [exercise 6.3]
  // The same with a single row, and only if the rope is overstretched; otherwise move nothing.
  todo("6.3");
  // end [exercise 6.3]
}

void projection_iteration(Chain& chain) {
  // begin [exercise 6.3]
  // Project every joint between its two bodies, one after the other.
  todo("6.3");
  // end [exercise 6.3]
}

// ---- the soft step ----------------------------------------------------------------------------

SoftRow soft_row(real frequency, real damping, real h) {
  // begin [exercise 6.4]
  // Return {rate, softness} of Eq. 6-15. std::numbers::pi_v<real> is pi.
  todo("6.4");
  // end [exercise 6.4]
}

void soft_iteration(const JointRows& rows, const SoftRow& soft, vec3& lambda, Body& body1,
                    Body& body2) {
  // begin [exercise 6.4]
  // Compute dlambda of Eq. 6-16, apply it to the bodies and add it to lambda. block_impulse of
  // exercise 2.3 gives -K^-1 (J V + b) of a hard block with the bias b.
  todo("6.4");
  // end [exercise 6.4]
}

void soft_step(Chain& chain, std::vector<vec3>& impulses, const SoftStep& how, const vec3& gravity,
               real h) {
  // begin [exercise 6.4]
  // Divide h into how.substeps equal parts. In each of them:
  //  1. integrate_forces(body, gravity, length of the part) for every body;
  //  2. rows_of(chain), and a warm_start of every joint with its impulse;
  //  3. one soft_iteration of every joint, in order, with the soft_row of how;
  //  4. move(chain, length of the part);
  //  5. how.relax times: one soft_iteration of every joint with SoftRow{}, which is hard and has
  //     no bias, with the rows of 2.
  todo("6.4");
  // end [exercise 6.4]
}

}  // namespace joints
