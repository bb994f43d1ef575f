// Known answers of exercise 9.8, each put in the place of the solution's.

// ---- wrong: h not squared
// expects: Likely mistake: h is squared: kappa h^2 |F||r|
// change: kappa * h * h * force_lever ==> kappa * h * force_lever

// ---- wrong: h missing
// expects: Likely mistake: h is missing: kappa h^2 |F||r|
// change: kappa * h * h * force_lever ==> kappa * force_lever

// ---- wrong: kappa missing
// expects: Likely mistake: kappa is missing: kappa h^2 |F||r|
// change: kappa * h * h * force_lever ==> h * h * force_lever

// ---- wrong: force missing
// expects: Likely mistake: the force is missing: kappa h^2 |F||r|
// change: kappa * h * h * force_lever ==> kappa * h * h

// ---- wrong: fixed kappa
// expects: Likely mistake: a fixed number: `kappa` is an argument
// change: kappa * h * h * force_lever ==> real(16) * h * h * force_lever

// ---- wrong: divided by h squared
// expects: Likely mistake: divided by h^2: times h^2
// change: kappa * h * h * force_lever ==> kappa / (h * h) * force_lever

// ---- wrong: inertia taken away
// expects: Likely mistake: the inertia is taken away: each moment grows
// change: moments + vec3 ==> moments - vec3

// ---- wrong: inertia multiplied
// expects: Likely mistake: the moments are multiplied by what is missing: it is added
// change: moments + vec3 ==> moments * vec3

// ---- wrong: added to the inverse
// expects: Exercise 9.8: a body with more inertia Case: mass 1 kg, force_lever 3
// change: moments + vec3 ==> body.inverse_inertia_local + vec3

// ---- wrong: least moment forgotten
// expects: Likely mistake: the least moment is not taken away: only what is missing is added
// change: - least - lever ==> - lever

// ---- wrong: least moment added
// expects: Likely mistake: the least moment is added: what is there is taken away
// change: - least - lever ==> + least - lever

// ---- wrong: greatest moment
// expects: Likely mistake: the greatest moment in the place of the least
// change: std::min({ ==> std::max({

// ---- wrong: first moment
// expects: Likely mistake: the first moment in the place of the least
// change: std::min({moments.x, moments.y, moments.z}) ==> moments.x

// ---- wrong: last moment
// expects: Likely mistake: the third moment in the place of the least
// change: std::min({moments.x, moments.y, moments.z}) ==> moments.z

// ---- wrong: mean moment
// expects: Likely mistake: the mean of the moments in the place of the least
// change: std::min({moments.x, moments.y, moments.z}) ==> (moments.x + moments.y + moments.z) / 3

// ---- wrong: lever forgotten
// expects: Likely mistake: m r^2 is not taken away: it is there, too
  const vec3 moments = real(1) / body.inverse_inertia_local;
  const real least = std::min({moments.x, moments.y, moments.z});
  const real missing = kappa * h * h * force_lever - least ;
  const vec3 more = moments + vec3(std::max(real(0), missing));  // Eq. 9-14
  out.inverse_inertia_local = real(1) / more;
  out.w = to_world(body, moments / more * to_local(body, body.w));

// ---- wrong: lever added
// expects: Likely mistake: m r^2 is added: what is there is taken away
// change: - lever * lever / body.inverse_mass ==> + lever * lever / body.inverse_mass

// ---- wrong: lever not squared
// expects: Likely mistake: r is squared: m r^2
// change: lever * lever / body ==> lever / body

// ---- wrong: lever times inverse mass
// expects: Likely mistake: divided by the mass: inverse_mass is 1/m, so divide by it
// change: lever * lever / body.inverse_mass ==> lever * lever * body.inverse_mass

// ---- wrong: mass forgotten
// expects: Likely mistake: the mass is missing: m r^2
// change: lever * lever / body.inverse_mass ==> lever * lever

// ---- wrong: negative missing
// expects: Likely mistake: what is missing may be negative: then nothing is added, at least 0
// change: vec3(std::max(real(0), missing)) ==> vec3(missing)

// ---- wrong: lower bound exchanged
// expects: Likely mistake: the lesser of 0 and what is missing: the greater
// change: std::max(real(0), missing) ==> std::min(real(0), missing)

// ---- wrong: all of it where something is missing
// expects: Likely mistake: all of kappa h^2 |F||r| is added where something is missing: only
// change: std::max(real(0), missing) ==> missing > 0 ? kappa * h * h * force_lever : real(0)

// ---- wrong: old rule, always all of it
// expects: Likely mistake: nothing that is there is taken away: only what is missing is added
// change: std::max(real(0), missing) ==> kappa * h * h * force_lever

// ---- wrong: each axis what it lacks itself
// expects: Likely mistake: each moment lacks something of its own here: what the least one lacks
// change: moments + vec3(std::max(real(0), missing)) ==> glm::max(moments, vec3(missing + least))

// ---- wrong: only the size of what is missing
// expects: Likely mistake: the size of what is missing: where it is negative there is enough, and
// change: std::max(real(0), missing) ==> std::abs(missing)

// ---- wrong: force times lever again
// expects: Likely mistake: force_lever is |F||r| already: it is not multiplied by the lever once
// change: kappa * h * h * force_lever ==> kappa * h * h * force_lever * lever

// ---- wrong: inverse moments taken for moments
// expects: Likely mistake: the inverse moments are taken for moments: 1 over each of them first
// change: const vec3 moments = real(1) / body.inverse_inertia_local ==>
//         const vec3 moments = body.inverse_inertia_local

// ---- wrong: moments returned
// expects: Likely mistake: the moments are returned: 1 over each of them
// change: out.inverse_inertia_local = real(1) / more ==> out.inverse_inertia_local = more

// ---- wrong: old inertia returned
// expects: Likely mistake: in inverse_inertia alone: the force is never looked at, and nothing
// change: out.inverse_inertia_local = real(1) / more ==>
//         out.inverse_inertia_local = body.inverse_inertia_local

// ---- wrong: w stays
// expects: Likely mistake: the angular velocity stays: the angular momentum stays, so it becomes
// change: to_world(body, moments / more * to_local(body, body.w)) ==> body.w

// ---- wrong: w in the world's axes
// expects: Likely mistake: the angular velocity is scaled in the world's axes: to_local() first
// change: to_world(body, moments / more * to_local(body, body.w)) ==> moments / more * body.w

// ---- wrong: to_world missing
// expects: Likely mistake: to_world() is missing: w is in the world
// change: to_world(body, moments / more * to_local(body, body.w)) ==>
//         moments / more * to_local(body, body.w)

// ---- wrong: to_local missing
// expects: Likely mistake: to_local() is missing: the moments are those of the body's own axes
// change: to_local(body, body.w) ==> body.w

// ---- wrong: both exchanged
// expects: Likely mistake: to_local() and to_world() are exchanged
// change: to_world(body, moments / more * to_local(body, body.w)) ==>
//         to_local(body, moments / more * to_world(body, body.w))

// ---- wrong: ratio upside down
// expects: Likely mistake: the angular velocity becomes larger: the momentum I w stays, so
// change: moments / more ==> more / moments

// ---- wrong: momentum returned
// expects: Likely mistake: the angular momentum is returned: divide it by the new moments
// change: moments / more ==> moments

// ---- wrong: only divided
// expects: Likely mistake: only divided by the new moments: the momentum is the old moments times
// change: moments / more * ==> real(1) / more *

// ---- wrong: energy kept
// expects: Likely mistake: the energy is kept: it is the angular momentum that stays, without a
// change: moments / more * ==> glm::sqrt(moments / more) *

// ---- wrong: one ratio for all
// expects: Likely mistake: one ratio for all three: each axis has its own
// change: moments / more * ==> moments.x / more.x *

// ---- wrong: mean ratio
// expects: Likely mistake: one ratio for all three: each axis has its own
// change: moments / more * ==> (moments.x + moments.y + moments.z) / (more.x + more.y + more.z) *

// ---- wrong: only one moment grows
// expects: Likely mistake: only the first moment grows: all three
// change: vec3(std::max(real(0), missing)) ==> vec3(std::max(real(0), missing), 0, 0)

// ---- wrong: mass added
// expects: Exercise 9.8: a body with more inertia Case: mass 1 kg, force_lever 3
// change: moments + vec3 ==> moments + real(1) / body.inverse_mass + vec3

// ---- wrong: force doubled
// expects: Likely mistake: twice: kappa h^2 |F||r|
// change: kappa * h * h * force_lever ==> 2 * kappa * h * h * force_lever

// ---- wrong: force squared
// expects: Likely mistake: the force is squared: it is |F||r| itself
// change: * force_lever - least ==> * force_lever * force_lever - least

// ---- wrong: linear velocity
// expects: Likely mistake: the linear velocity: w is the angular one
// change: body.w) ==> body.v)

// ---- wrong: w not set
// expects: Likely mistake: the angular velocity becomes zero: the momentum stays
  const vec3 moments = real(1) / body.inverse_inertia_local;
  const real least = std::min({moments.x, moments.y, moments.z});
  const real missing = kappa * h * h * force_lever - least - lever * lever / body.inverse_mass;
  const vec3 more = moments + vec3(std::max(real(0), missing));  // Eq. 9-14
  out.inverse_inertia_local = real(1) / more;

// ---- wrong: inertia not set
// expects: Likely mistake: in inverse_inertia alone: 0 in every case: is it written at all, from
  const vec3 moments = real(1) / body.inverse_inertia_local;
  const real least = std::min({moments.x, moments.y, moments.z});
  const real missing = kappa * h * h * force_lever - least - lever * lever / body.inverse_mass;
  const vec3 more = moments + vec3(std::max(real(0), missing));  // Eq. 9-14
  out.w = to_world(body, moments / more * to_local(body, body.w));

// ---- wrong: a number in float
// expects: Likely mistake: right to a few digits only: is there a float among the reals, such as
// change: kappa * h * h ==> real(float(kappa * h * h))

// ---- wrong: isotropic bodies left out
// expects: Exercise 9.8: a body with more inertia Case: mass 2 kg, force_lever 90
// change: vec3(std::max(real(0), missing)) ==>
//         vec3(body.is_isotropic() ? real(0) : std::max(real(0), missing))

// ---- wrong: squared ratio
// expects: Likely mistake: the ratio is squared: moments / more, once
// change: moments / more * ==> moments / more * moments / more *

// ---- wrong: h cubed
// expects: Likely mistake: h to the third power: kappa h^2 |F||r|
// change: kappa * h * h * force_lever ==> kappa * h * h * h * force_lever

// ---- wrong units: lever not squared
// expects: Units: in stiffened, taking kg m from kg m^2: a lever is missing, or another length
// change: lever * lever / body ==> lever / body

// ---- wrong units: mass forgotten
// expects: Units: in stiffened, taking m^2 from kg m^2: the inverse mass is missing
// change: lever * lever / body.inverse_mass ==> lever * lever

// ---- wrong units: h not squared
// expects: Units: in stiffened, taking kg m^2 from kg m^2/s: a time too many: is a division by h
// change: kappa * h * h * force_lever ==> kappa * h * force_lever

// ---- wrong units: h missing
// expects: Units: in stiffened, taking kg m^2 from kg m^2/s^2
// change: kappa * h * h * force_lever ==> kappa * force_lever

// ---- wrong units: force missing
// expects: Units: in stiffened, taking kg m^2 from s^2
// change: kappa * h * h * force_lever ==> kappa * h * h

// ---- wrong units: inverse moments taken for moments
// expects: Units: in stiffened, taking 1/(kg m^2) from kg m^2: inertia where its inverse belongs
// change: const vec3 moments = real(1) / body.inverse_inertia_local ==>
//         const vec3 moments = body.inverse_inertia_local

// ---- wrong units: moments returned
// expects: Units: the inverse inertia is in kg m^2 and should be in 1/(kg m^2): inertia where its
// change: out.inverse_inertia_local = real(1) / more ==> out.inverse_inertia_local = more

// ---- wrong units: momentum returned
// expects: Units: the angular velocity w is in kg m^2/s and should be in 1/s: the inverse inertia
// change: moments / more * ==> moments *

// ---- wrong units: only divided
// expects: Units: the angular velocity w is in 1/(kg m^2 s) and should be in 1/s: an inverse
// change: moments / more * ==> real(1) / more *

// ---- wrong units: linear velocity
// expects: Units: the angular velocity w is in m/s and should be in 1/s: a length too many: a
// change: body.w) ==> body.v)

// ---- right: in the world's axes with a matrix
  const mat3 R = mat3_cast(body.q);
  const vec3 before = real(1) / body.inverse_inertia_local;
  real there = before.x < before.y ? before.x : before.y;
  if (before.z < there) there = before.z;
  there += lever * lever / body.inverse_mass;
  const real follows = h * h * kappa * force_lever;
  const vec3 after = before + vec3(follows > there ? follows - there : real(0));
  const mat3 old(R[0] * before.x, R[1] * before.y, R[2] * before.z);
  const mat3 next(R[0] / after.x, R[1] / after.y, R[2] / after.z);
  out.inverse_inertia_local = real(1) / after;
  out.w = next * transpose(R) * (old * transpose(R) * body.w);

// ---- right: the body as it is where it has enough
  const vec3& inverse = body.inverse_inertia_local;
  const real greatest = std::max({inverse.x, inverse.y, inverse.z});
  const real missing = kappa * h * h * force_lever - 1 / greatest - lever * lever /
      body.inverse_mass;
  if (missing <= 0) return {inverse, body.w};
  out.inverse_inertia_local = inverse / (real(1) + missing * inverse);
  const vec3 momentum = to_local(body, body.w) / inverse;
  out.w = to_world(body, out.inverse_inertia_local * momentum);
