// Known answers of exercise 9.8, each put in the place of the solution's.

// ---- wrong: h not squared
// expects: Likely mistake: h is squared: factor h^2 |F||r|
// change: factor * h * h * force_lever ==> factor * h * force_lever

// ---- wrong: h missing
// expects: Likely mistake: h is missing: factor h^2 |F||r|
// change: factor * h * h * force_lever ==> factor * force_lever

// ---- wrong: factor missing
// expects: Likely mistake: the factor is missing: factor h^2 |F||r|
// change: factor * h * h * force_lever ==> h * h * force_lever

// ---- wrong: force missing
// expects: Likely mistake: the force is missing: factor h^2 |F||r|
// change: factor * h * h * force_lever ==> factor * h * h

// ---- wrong: fixed factor
// expects: Likely mistake: a fixed factor of 16: `factor` is one
// change: factor * h * h * force_lever ==> real(16) * h * h * force_lever

// ---- wrong: divided by h squared
// expects: Likely mistake: divided by h^2: times h^2
// change: factor * h * h * force_lever ==> factor / (h * h) * force_lever

// ---- wrong: inertia taken away
// expects: Likely mistake: the inertia is taken away: each moment grows
// change: moments + factor ==> moments - factor

// ---- wrong: inertia multiplied
// expects: Likely mistake: times 1 + factor h^2 |F||r|: that is added to the moment
// change: moments + factor * h * h * force_lever ==>
//         moments * (real(1) + factor * h * h * force_lever)

// ---- wrong: added to the inverse
// expects: Likely mistake: in inverse_inertia alone: the inverse moments are taken for moments: 1
// change: moments + factor ==> body.inverse_inertia_local + factor

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
// expects: Likely mistake: only one moment grows: all three
// change: moments + factor * h * h * force_lever ==>
//         moments + vec3(0, factor * h * h * force_lever, 0)

// ---- wrong: mass added
// expects: Likely mistake: the mass is added, too: only factor h^2 |F||r|
// change: moments + factor ==> moments + real(1) / body.inverse_mass + factor

// ---- wrong: force doubled
// expects: Likely mistake: twice: factor h^2 |F||r|
// change: factor * h * h * force_lever ==> 2 * factor * h * h * force_lever

// ---- wrong: force squared
// expects: Likely mistake: the force is squared: it is |F||r| itself
// change: * force_lever ==> * force_lever * force_lever

// ---- wrong: linear velocity
// expects: Likely mistake: the linear velocity: w is the angular one
// change: body.w) ==> body.v)

// ---- wrong: w not set
// expects: Likely mistake: the angular velocity becomes zero: the momentum stays
  const vec3 moments = real(1) / body.inverse_inertia_local;
  const vec3 more = moments + factor * h * h * force_lever;  // Eq. 9-14
  out.inverse_inertia_local = real(1) / more;

// ---- wrong: inertia not set
// expects: Likely mistake: in inverse_inertia alone: 0 in every case: is it written at all, from
  const vec3 moments = real(1) / body.inverse_inertia_local;
  const vec3 more = moments + factor * h * h * force_lever;  // Eq. 9-14
  out.w = to_world(body, moments / more * to_local(body, body.w));

// ---- wrong: a number in float
// expects: Likely mistake: right to a few digits only: is there a float among the reals, such as
// change: factor * h * h ==> real(float(factor * h * h))

// ---- wrong: at most twice the inertia
// expects: Exercise 9.8: a body with more inertia Case: force_lever 1 N m, factor
// change: moments + factor * h * h * force_lever ==>
//         glm::min(moments + factor * h * h * force_lever, real(2) * moments)

// ---- wrong: the larger of both
// expects: Likely mistake: the greater one of moment and factor h^2 |F||r|: their sum
// change: moments + factor * h * h * force_lever ==>
//         glm::max(moments, vec3(factor * h * h * force_lever))

// ---- wrong: isotropic bodies left out
// expects: Exercise 9.8: a body with more inertia Case: force_lever 30 N m, facto
// change: moments + factor * h * h * force_lever ==>
//         moments + (body.is_isotropic() ? real(0) : factor * h * h * force_lever)

// ---- wrong: squared ratio
// expects: Likely mistake: the ratio is squared: moments / more, once
// change: moments / more * ==> moments / more * moments / more *

// ---- wrong: h cubed
// expects: Likely mistake: h to the third power: factor h^2 |F||r|
// change: factor * h * h * force_lever ==> factor * h * h * h * force_lever

// ---- wrong units: h not squared
// expects: Units: in stiffened, adding kg m^2/s to kg m^2: h is missing (an impulse is h times a
// change: factor * h * h * force_lever ==> factor * h * force_lever

// ---- wrong units: h missing
// expects: Units: in stiffened, adding kg m^2/s^2 to kg m^2
// change: factor * h * h * force_lever ==> factor * force_lever

// ---- wrong units: force missing
// expects: Units: in stiffened, adding s^2 to kg m^2
// change: factor * h * h * force_lever ==> factor * h * h

// ---- wrong units: inverse moments taken for moments
// expects: Units: in stiffened, adding kg m^2 to 1/(kg m^2): inertia where its inverse belongs
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
// expects: Units: the angular velocity w is in m/s and should be in 1/s: a length too many: an
// change: body.w) ==> body.v)

// ---- right: in the world's axes with a matrix
  const mat3 R = mat3_cast(body.q);
  const vec3 before = real(1) / body.inverse_inertia_local;
  const vec3 after = before + vec3(h * h * factor * force_lever);
  const mat3 old(R[0] * before.x, R[1] * before.y, R[2] * before.z);
  const mat3 next(R[0] / after.x, R[1] / after.y, R[2] / after.z);
  out.inverse_inertia_local = real(1) / after;
  out.w = next * transpose(R) * (old * transpose(R) * body.w);

// ---- right: component by component
  const vec3 local = to_local(body, body.w);
  vec3 w(0);
  for (int k = 0; k < 3; ++k) {
    const real inverse = body.inverse_inertia_local[k];
    const real ratio = 1 + inverse * factor * force_lever * h * h;
    out.inverse_inertia_local[k] = inverse / ratio;
    w[k] = local[k] / ratio;
  }
  out.w = to_world(body, w);
