// Known answers of exercise 1.3, each put in the place of the solution's.

// ---- wrong: body space inertia
// region: 2
// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
// change: inverse_inertia(body1) ==> body1.inverse_inertia_local
// change: inverse_inertia(body2) ==> body2.inverse_inertia_local

// ---- wrong: one sign too many
// region: 2
// expects: Likely mistake: the sign: velocities grow by +M^-1 J^T lambda
// change: += body1 ==> -= body1
// change: += inverse_inertia ==> -= inverse_inertia

// ---- wrong: only where there is an error
// expects: Likely mistake: nothing is done where the bias is 0. C = 0 does not mean that there is
// expects: nothing to solve
// change: == 0 ==> == 0 || std::abs(bias) < epsilon

// ---- wrong: without bias
// expects: Likely mistake: the bias is missing: the error is not fed back
  if (K == 0) return 0;
  return -row_velocity(J, body1, body2) / K;

// ---- wrong: a small K taken for none
// expects: Likely mistake: nothing is done where K is small
// change: == 0 ==> < real(1e-3)

// ---- wrong: a smaller K taken for none
// expects: Likely mistake: nothing is done where K is small
// change: == 0 ==> < real(1e-9)

// ---- wrong: nothing asked of K
// expects: Likely mistake: a division by zero
  return -(row_velocity(J, body1, body2) + bias) / K;

// ---- wrong: condition the wrong way round
// expects: Likely mistake: 0 is returned where K is not 0
// change: == 0 ==> != 0

// ---- wrong: bias where nothing can move
// expects: Likely mistake: where K is 0 nothing can be moved: lambda is 0
// change: 0; ==> bias;

// ---- wrong: sign of the impulse
// expects: Likely mistake: the sign: the impulse works against J V + b
// change: return - ==> return

// ---- wrong: sign of the bias
// expects: Likely mistake: the sign of the bias
// change: + bias ==> - bias

// ---- wrong: brackets forgotten, bias over K
// expects: Likely mistake: only the bias is divided by K
  if (K == 0) return 0;
  return -row_velocity(J, body1, body2) + bias / K;

// ---- wrong: brackets forgotten, rate over K
// expects: Likely mistake: only J V is divided by K
  if (K == 0) return 0;
  return -row_velocity(J, body1, body2) / K + bias;

// ---- wrong: without K
// expects: Likely mistake: K is missing: a velocity is no impulse
// change: / K ==>

// ---- wrong: times K
// expects: Likely mistake: times K where its inverse belongs
// change: / K ==> * K

// ---- wrong: bodies exchanged in J V
// expects: Likely mistake: bodies 1 and 2 are exchanged in J V
// change: body1, body2 ==> body2, body1

// ---- wrong: angular velocities left out
// expects: Likely mistake: the angular velocities are missing in J V
// change: row_velocity(J, body1, body2) ==> (dot(J.v1, body1.v) + dot(J.v2, body2.v))

// ---- wrong: J V of a rod
// expects: Likely mistake: J V is written out as if J.v1 and J.v2 were known
// change: row_velocity(J, body1, body2) ==> dot(J.v2, body2.v - body1.v)

// ---- wrong: K of a rod
// expects: Likely mistake: K is given: it is 1/m1 + 1/m2 in a rod from centre to centre alone
// change: K; ==> (body1.inverse_mass + body2.inverse_mass);

// ---- wrong: never a pull
// expects: Likely mistake: a row may push and pull
  if (K == 0) return 0;
  return glm::max(-(row_velocity(J, body1, body2) + bias) / K, real(0));

// ---- wrong: size of the impulse
// expects: Likely mistake: the sign is lost
// change: return - ==> return std::abs

// ---- wrong: only where something moves
// expects: Likely mistake: nothing is done where J V is 0
// change: K == ==> K == 0 || row_velocity(J, body1, body2) ==

// ---- wrong: small rates left out
// expects: Likely mistake: nothing is done where J V + b is small
// change: return - ==>
//         if (std::abs(row_velocity(J, body1, body2) + bias) < real(1e-6)) return 0; return -

// ---- wrong: nothing beside a wall
// expects: Likely mistake: nothing is done where one body is static
// change: K == 0 ==> body1.is_static() || body2.is_static()

// ---- wrong: beta once more
// expects: Likely mistake: the bias b is used as it is
// change: bias ==> real(0.2) * bias

// ---- wrong: a sum that was never set
// expects: Likely mistake: a value that was never set
  if (K == 0) return 0;
  real e;
  e += row_velocity(J, body1, body2) + bias;
  return -e / K;

// ---- wrong: velocities set
// region: 2
// expects: Likely mistake: the velocity is set where it must grow: += and not = (v1, w1, v2 and w2)
  body1.v = body1.inverse_mass * lambda * J.v1;
  body1.w = inverse_inertia(body1) * (lambda * J.w1);
  body2.v = body2.inverse_mass * lambda * J.v2;
  body2.w = inverse_inertia(body2) * (lambda * J.w2);

// ---- wrong: angular velocities forgotten
// region: 2
// expects: Likely mistake: not changed at all (w1 and w2)
  body1.v += body1.inverse_mass * lambda * J.v1;
  body2.v += body2.inverse_mass * lambda * J.v2;

// ---- wrong: both shares to body 1
// region: 2
// expects: Likely mistake: the share of body 2 is given to body 1
// change: body2 ==> body1
// change: body2.w ==> body1.w

// ---- wrong: blocks of body 1 for both
// region: 2
// expects: Likely mistake: the block v of the other body (v2); the block w of the other body (w2)
// change: v2; ==> v1;
// change: w2 ==> w1

// ---- wrong: blocks v for w
// region: 2
// expects: Likely mistake: the block v of the row where w belongs (w1 and w2)
// change: w1 ==> v1
// change: w2 ==> v2

// ---- wrong: masses exchanged
// region: 2
// expects: Likely mistake: the inverse mass of the other body (v1 and v2)
// change: += body1 ==> += body2
// change: body2.v += body2 ==> body2.v += body1

// ---- wrong: without lambda
// region: 2
// expects: Likely mistake: lambda is missing (v1, w1, v2 and w2)
  body1.v += body1.inverse_mass * J.v1;
  body1.w += inverse_inertia(body1) * (J.w1);
  body2.v += body2.inverse_mass * J.v2;
  body2.w += inverse_inertia(body2) * (J.w2);

// ---- wrong: masses for inverse masses
// region: 2
// expects: Likely mistake: mass where inverse mass belongs (v1 and v2)
  body1.v += lambda * J.v1 / body1.inverse_mass;
  body1.w += inverse_inertia(body1) * (lambda * J.w1);
  body2.v += lambda * J.v2 / body2.inverse_mass;
  body2.w += inverse_inertia(body2) * (lambda * J.w2);

// ---- wrong: inertia for its inverse
// region: 2
// expects: Likely mistake: inertia where inverse inertia belongs (w1 and w2)
// change: inverse_inertia(body1) ==> inverse(inverse_inertia(body1))
// change: inverse_inertia(body2) ==> inverse(inverse_inertia(body2))

// ---- wrong: nothing moves beside a wall
// region: 2
// expects: Likely mistake: nothing is done where one body is static
// change: body1 ==> if (body1.is_static() || body2.is_static()) return; body1

// ---- wrong: small impulses left out
// region: 2
// expects: Likely mistake: a small lambda is left out
// change: body1 ==> if (std::abs(lambda) < real(1e-6)) return; body1

// ---- wrong: negative impulses left out
// region: 2
// expects: Likely mistake: a negative lambda is left out
// change: body1 ==> if (lambda < 0) return; body1

// ---- wrong: copies of the bodies
// region: 2
// expects: Likely mistake: not changed at all (v1, w1, v2 and w2)
  Body a = body1, b = body2;
  a.v += body1.inverse_mass * lambda * J.v1;
  a.w += inverse_inertia(body1) * (lambda * J.w1);
  b.v += body2.inverse_mass * lambda * J.v2;
  b.w += inverse_inertia(body2) * (lambda * J.w2);

// ---- wrong: positions moved, too
// region: 2
// expects: Likely mistake: an impulse changes velocities and not positions (x)
// change: v2; ==> v2; body1.x += body1.v / real(60);

// ---- wrong: sign of the bias and K not asked for
// expects: Likely mistake: the sign of the bias; and K = 0 is divided by
  return -(row_velocity(J, body1, body2) - bias) / K;

// ---- wrong: sign and a small K taken for none
// expects: Likely mistake: the sign: the impulse works against J V + b; and nothing is done where
  if (K < real(1e-3)) return 0;
  return (row_velocity(J, body1, body2) + bias) / K;

// ---- wrong: body 1 left out of J V
// expects: Likely mistake: body 1 is missing in J V
// change: row_velocity(J, body1, body2) ==> (dot(J.v2, body2.v) + dot(J.w2, body2.w))

// ---- wrong: minus for body 1 in J V
// expects: Likely mistake: the sign of a body in J V
  if (K == 0) return 0;
  const real rate = dot(J.v2, body2.v) + dot(J.w2, body2.w) - dot(J.v1, body1.v) -
                    dot(J.w1, body1.w);
  return -(rate + bias) / K;

// ---- wrong: without masses and inertias
// region: 2
// expects: Likely mistake: the inverse mass is missing (v1 and v2); the inverse inertia is missing
// expects: (w1 and w2)
  body1.v += lambda * J.v1;
  body1.w += (lambda * J.w1);
  body2.v += lambda * J.v2;
  body2.w += (lambda * J.w2);

// ---- right: K not positive
// K is never negative, so that K <= 0 asks the same as K == 0.
  return K <= 0 ? real(0) : -(row_velocity(J, body1, body2) + bias) / K;

// ---- right: J V written out
  if (K == 0) return 0;
  const real JV = dot(J.v1, body1.v) + dot(J.w1, body1.w) + dot(J.v2, body2.v) +
                  dot(J.w2, body2.w);
  return -(JV + bias) / K;

// ---- right: times the effective mass
// change: / K ==> * (1 / K)

// ---- right: vector times symmetric matrix
// region: 2
  body1.v += body1.inverse_mass * lambda * J.v1;
  body1.w += lambda * J.w1 * inverse_inertia(body1);
  body2.v += body2.inverse_mass * lambda * J.v2;
  body2.w += inverse_inertia(body2) * (lambda * J.w2);

// ---- right: walls left out
// region: 2
// change: body1 ==> if (body1.is_static() && body2.is_static()) return; body1

// ---- wrong units: without inverse mass
// region: 2
// expects: Units: in V + M^-1 J^T lambda, adding kg m/s to m/s: the inverse mass is missing
// change: body1.inverse_mass * ==>
// change: body2.inverse_mass * ==>
