// Known answers of exercise 3.2, each put in the place of the solution's.

// ---- wrong: body 1 missing
// expects: Likely mistake: body 1 is missing
  return body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- wrong: body space inertia
// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, body1.inverse_inertia_local * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, body2.inverse_inertia_local * b.w2);

// ---- wrong: inertia of the other body
// expects: Likely mistake: the inertia of the other body
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body2) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body1) * b.w2);

// ---- wrong: mass for inverse mass
// expects: Likely mistake: masses where inverse masses belong: M^-1 divides by the mass
  const auto mass = [](const Body& body) {
    return body.is_static() ? real(0) : 1 / body.inverse_mass;
  };
  return mass(body1) * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         mass(body2) * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);

// ---- wrong: one term forgotten
// expects: the turn of body 2 is missing
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2);

// ---- wrong: without turns
// expects: Likely mistake: the turns are missing: the blocks w1 and w2
  return body1.inverse_mass * dot(a.v1, b.v1) + body2.inverse_mass * dot(a.v2, b.v2);

// ---- right: velocities first
// First what an impulse of 1 along b does to the velocities, then the rate that row a sees.
  Body one = body1, two = body2;
  one.v = body1.inverse_mass * b.v1;
  one.w = inverse_inertia(body1) * b.w1;
  two.v = body2.inverse_mass * b.v2;
  two.w = inverse_inertia(body2) * b.w2;
  return row_velocity(a, one, two);
