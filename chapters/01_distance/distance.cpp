// Chapter 1: one row. Replace each todo(...) with your own code. README.md has the text.
#include "chapters/01_distance/distance.h"

#include <algorithm>
#include <cmath>

#include "engine/instruments/todo.h"

namespace joints {

// ---- a rod from centre to centre ---------------------------------------------------------

Row CentreDistance::jacobian(const Body& body1, const Body& body2) const {
  // begin [exercise 1.1]
  // Return J, the factors of the velocities in Eq. 1-3. x1 is body1.x. A Row is written
  // {v1, w1, v2, w2}; a zero vector is vec3(0). direction(u) gives the unit vector along u.
  todo("1.1");
  // end [exercise 1.1]
}

real CentreDistance::K(const Body& body1, const Body& body2) const {
  // begin [exercise 1.2]
  // Return K: by how much lambda = 1 changes J V. A body stores 1/m: body1.inverse_mass.
  todo("1.2");
  // end [exercise 1.2]
}

// ---- the impulse of one row ----------------------------------------------------------------

real row_impulse(const Row& J, real K, real bias, const Body& body1, const Body& body2) {
  // begin [exercise 1.3]
  // Return lambda of Eq. 1-8, and 0 where K is 0. row_velocity(J, body1, body2) gives J V.
  todo("1.3");
  // end [exercise 1.3]
}

void apply_impulse(const Row& J, real lambda, Body& body1, Body& body2) {
  // begin [exercise 1.3]
  // Change v and w of both bodies by M^-1 J^T lambda, Eq. 1-6.
  // inverse_inertia(body) gives the inverse inertia in world axes as a mat3.
  todo("1.3");
  // end [exercise 1.3]
}

// ---- the step --------------------------------------------------------------------------------

LinkRow set_up(const Link& link, const std::vector<Body>& bodies, const StepSettings& settings) {
  const Body &body1 = bodies[link.body1], &body2 = bodies[link.body2];
  const CentreDistance rod{link.length};
  const Rope<CentreDistance> rope{rod};
  const real C = link.rope ? rope.error(body1, body2) : rod.error(body1, body2);
  LinkRow row;
  row.J = link.rope ? rope.jacobian(body1, body2) : rod.jacobian(body1, body2);
  row.K = rod.K(body1, body2);
  row.bias = settings.beta * C / settings.h;                 // feedback of the error, chapter 6
  if (link.rope && C > 0) row.bias = C / settings.h;         // allow the slack to close, Eq. 1-11
  return row;
}

void step(std::vector<Body>& bodies, const std::vector<Link>& links,
          const StepSettings& settings) {
  // begin [exercise 1.4]
  // Write Algorithm 1 in four pieces:
  //  1. Gravity changes v of every body that is not static (body.is_static()).
  //  2. set_up(link, bodies, settings) gives the LinkRow of a link. Store one for each link.
  //  3. Repeat settings.iterations times: for every link call row_impulse, for a rope also
  //     clamp_sum (exercise 1.5), then apply_impulse.
  //  4. The new v moves x of every body that is not static.
  todo("1.4");
  // end [exercise 1.4]
}

// ---- a rope: its accumulated impulse must not push ---------------------------------------------

real clamp_sum(real dlambda, real& sum) {
  // begin [exercise 1.5]
  // Add dlambda to the accumulated impulse and clamp the result to at least 0. Store it in `sum`
  // and return its change (Eq. 1-12).
  todo("1.5");
  // end [exercise 1.5]
}

// ---- a rod from any point to any point ----------------------------------------------------------

Row Distance::jacobian(const Body& body1, const Body& body2) const {
  // begin [exercise 1.6]
  // Return the row J of Eq. 1-15. The levers r1, r2 and the points p1, p2 are in world space:
  // to_world(body1, anchor1_local) gives a lever, and world_point gives the point.
  todo("1.6");
  // end [exercise 1.6]
}

real Distance::K(const Body& body1, const Body& body2) const {
  // begin [exercise 1.6]
  // Return K of Eq. 1-16. inverse_inertia(body) is the inverse inertia in world axes, a mat3.
  todo("1.6");
  // end [exercise 1.6]
}

}  // namespace joints
