// Known answers of exercise 3.2, each put in the place of the solution's.

// ---- wrong: a copied block
// expects: Likely mistake: a.w1 where a.w2 belongs
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w1, inverse_inertia(body2) * b.w2);

// ---- wrong: a sum that is thrown away
// expects: Likely mistake: body 2 is missing
  real k;
  k = body1.inverse_mass * dot(a.v1, b.v1);
  k = k + dot(a.w1, inverse_inertia(body1) * b.w1);
  k + body2.inverse_mass * dot(a.v2, b.v2);
  k + dot(a.w2, inverse_inertia(body2) * b.w2);
  return k;

// ---- wrong: a w2 with a w2
// expects: Likely mistake: row a stands on both sides in the turn of body 2
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * a.w2);

// ---- wrong: abs
// expects: Likely mistake: an absolute value: the sign is lost
  return std::abs(body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2));

// ---- wrong: body 1 missing
// expects: Likely mistake: body 1 is missing
  return body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- wrong: body space inertia
// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, body1.inverse_inertia_local * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, body2.inverse_inertia_local * b.w2);

// ---- wrong: crossed v1 with v2
// expects: Likely mistake: blocks of body 1 with those of body 2: v1 with v1, w1 with w1
  return body1.inverse_mass * dot(a.v1, b.v2) + dot(a.w1, inverse_inertia(body1) * b.w2) +
         body2.inverse_mass * dot(a.v2, b.v1) + dot(a.w2, inverse_inertia(body2) * b.w1);

// ---- wrong: divided by the inverse mass
// expects: Likely mistake: masses where inverse masses belong: M^-1 divides by the mass
  return dot(a.v1, b.v1) / body1.inverse_mass + dot(a.w1, inverse_inertia(body1) * b.w1) +
         dot(a.v2, b.v2) / body2.inverse_mass + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- wrong: float
// expects: Likely mistake: right to a few digits only: is there a float among the reals
  return float(body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2));

// ---- wrong: inertia of body 1 for both
// expects: Likely mistake: the inertia of body 1 for both bodies: each has its own
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body1) * b.w2);

// ---- wrong: inertia of the other body
// expects: Likely mistake: the inertia of the other body
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body2) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body1) * b.w2);

// ---- wrong: inertia rotated wrong
// expects: Likely mistake: the inertia is turned the wrong way round: R I^-1 R^T, not R^T I^-1 R
  const mat3 R1 = glm::mat3_cast(body1.q), R2 = glm::mat3_cast(body2.q);
  const auto local = [](const Body& body) {
    const vec3 I = body.inverse_inertia_local;
    return mat3(I.x, 0, 0, 0, I.y, 0, 0, 0, I.z);
  };
  const mat3 L1 = local(body1), L2 = local(body2);
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, transpose(R1) * L1 * R1 * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, transpose(R2) * L2 * R2 * b.w2);

// ---- wrong: int sum
// expects: Likely mistake: the sum is an int: it cuts the fraction off
  int k = 0;
  k += body1.inverse_mass * dot(a.v1, b.v1);
  k += dot(a.w1, inverse_inertia(body1) * b.w1);
  k += body2.inverse_mass * dot(a.v2, b.v2);
  k += dot(a.w2, inverse_inertia(body2) * b.w2);
  return k;

// ---- wrong: local inertia of body 2 only
// expects: Likely mistake: body-space inertia of body 2: take inverse_inertia(body)
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, body2.inverse_inertia_local * b.w2);

// ---- wrong: local rows
// expects: Likely mistake: rows in the body's axes with an inertia in the world's:
// expects: inverse_inertia(body) takes the rows as they are
  const auto turn = [](const Body& body, const vec3& p, const vec3& q) {
    return dot(to_local(body, p), inverse_inertia(body) * to_local(body, q));
  };
  return body1.inverse_mass * dot(a.v1, b.v1) + turn(body1, a.w1, b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + turn(body2, a.w2, b.w2);

// ---- wrong: mass for inverse mass
// expects: Likely mistake: masses where inverse masses belong: M^-1 divides by the mass
  const auto mass = [](const Body& body) {
    return body.is_static() ? real(0) : 1 / body.inverse_mass;
  };
  return mass(body1) * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         mass(body2) * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- wrong: mass of body 2 for both
// expects: Likely mistake: the inverse mass of body 2 for both bodies: each has its own
  return body2.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- wrong: max 0
// expects: Likely mistake: what is negative has become 0
  const real k = body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
  return std::max(k, real(0));

// ---- wrong: minus body 1
// expects: Likely mistake: the sign of body 1's share: the shares of both bodies are added
  return -body1.inverse_mass * dot(a.v1, b.v1) - dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- wrong: minus turn of body 1
// expects: Likely mistake: the sign of the turn of body 1: the blocks w1
  return body1.inverse_mass * dot(a.v1, b.v1) - dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- wrong: one term forgotten
// expects: the turn of body 2 is missing
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2);

// ---- wrong: only local side
// expects: Likely mistake: one side is turned into the body's axes and not the other: take
// expects: inverse_inertia(body)
  const auto answer = [](const Body& body, const vec3& q) {
    return body.inverse_inertia_local * to_local(body, q);
  };
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, answer(body1, b.w1)) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, answer(body2, b.w2));

// ---- wrong: set for added
// expects: Likely mistake: only the turn of body 2 is left: the blocks w2. Is an = there where +=
// expects: belongs?
  real k = body1.inverse_mass * dot(a.v1, b.v1);
  k += dot(a.w1, inverse_inertia(body1) * b.w1);
  k += body2.inverse_mass * dot(a.v2, b.v2);
  k = dot(a.w2, inverse_inertia(body2) * b.w2);
  return k;

// ---- wrong: threshold
// expects: Likely mistake: what is small has become 0: no threshold belongs here
  const real k = body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
  return std::abs(k) < 0.1 ? 0 : k;

// ---- wrong: unset sum
// expects: Likely mistake: a value that was never set
  real k;
  k += body1.inverse_mass * dot(a.v1, b.v1);
  k += dot(a.w1, inverse_inertia(body1) * b.w1);
  k += body2.inverse_mass * dot(a.v2, b.v2);
  k += dot(a.w2, inverse_inertia(body2) * b.w2);
  return k;

// ---- wrong: w terms without inertia of body 1
// expects: Likely mistake: the inverse inertia of body 1 is missing
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- wrong: w1 for w2
// expects: Likely mistake: w1 where w2 belongs: body 2 takes its own blocks, a.w2 and b.w2
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w1, inverse_inertia(body2) * b.w1);

// ---- wrong: without turns
// expects: Likely mistake: the angular parts are missing: the blocks w1 and w2
  return body1.inverse_mass * dot(a.v1, b.v1) + body2.inverse_mass * dot(a.v2, b.v2);

// ---- wrong: zero
// expects: Likely mistake: 0 in every case: is it written at all, from what is given? Was it
// expects: cut off by an int, or something in it never set?
  return 0;

// ---- wrong: zero for a static body
// expects: Likely mistake: a static body has an answer, too: its own share is 0, the other body's
// expects: is not
  if (body1.is_static() || body2.is_static()) return 0;
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- wrong: zero for a static body 2
// expects: Likely mistake: a static body 2 has an answer, too: its own share is 0, body 1's is not
  if (body2.is_static()) return 0;
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- right: in body axes
  const auto turn = [](const Body& body, const vec3& p, const vec3& q) {
    return dot(to_local(body, p), body.inverse_inertia_local * to_local(body, q));
  };
  return body1.inverse_mass * dot(a.v1, b.v1) + turn(body1, a.w1, b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + turn(body2, a.w2, b.w2);

// ---- right: static left out
  real k = 0;
  if (!body1.is_static())
    k += body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1);
  if (!body2.is_static())
    k += body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
  return k;

// ---- right: transposed product
  return body1.inverse_mass * dot(b.v1, a.v1) + dot(a.w1 * inverse_inertia(body1), b.w1) +
         body2.inverse_mass * dot(b.v2, a.v2) + dot(a.w2 * inverse_inertia(body2), b.w2);

// ---- right: velocities first
// First what an impulse of 1 along b does to the velocities, then the rate that row a sees.
  Body one = body1, two = body2;
  one.v = body1.inverse_mass * b.v1;
  one.w = inverse_inertia(body1) * b.w1;
  two.v = body2.inverse_mass * b.v2;
  two.w = inverse_inertia(body2) * b.w2;
  return row_velocity(a, one, two);
