// Known answers of exercise 6.2, each put in the place of the solution's.

// ---- wrong: added to lambda
// expects: Likely mistake: the ratio is added to lambda: it is a factor
// change: lambda *= ratio ==> lambda += vec3(ratio)

// ---- wrong: applied before it is scaled
// expects: change of v2 (on paper).y
// expects: Likely mistake: the old impulse is applied and the scaled one is kept
  apply_impulse(J, lambda, body1, body2);
  lambda *= ratio;

// ---- wrong: body space inertia
// expects: Likely mistake: body-space inertia in w1 and w2: take inverse_inertia(body)
  lambda *= ratio;
  for (int i = 0; i < 3; ++i) {
    body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
    body1.w += body1.inverse_inertia_local * (lambda[i] * J[i].w1);
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
    body2.w += body2.inverse_inertia_local * (lambda[i] * J[i].w2);
  }

// ---- wrong: divided by the ratio
// expects: Likely mistake: divided by the ratio
// change: *= ratio ==> /= ratio

// ---- wrong: kept below one
// expects: longer step
// expects: Likely mistake: the ratio is kept below 1: a longer step needs more
// change: ratio ==> std::min(ratio, real(1))

// ---- wrong: masses of the other body
// expects: Likely mistake: the inverse mass and inertia of the other body in all four lines
// change: apply_impulse(J, lambda, body1, body2); ==>
//         for (int i = 0; i < 3; ++i) { body1.v += body2.inverse_mass * lambda[i] * J[i].v1;
//         body1.w += inverse_inertia(body2) * (lambda[i] * J[i].w1); body2.v += body1.inverse_mass
//         * lambda[i] * J[i].v2; body2.w += inverse_inertia(body1) * (lambda[i] * J[i].w2); }

// ---- wrong: new velocities
// expects: Likely mistake: v1, w1, v2 and w2 take a new value where it is added to the old one
// change: lambda *= ratio; ==> lambda *= ratio; body1.v = body1.w = body2.v = body2.w = vec3(0);

// ---- wrong: nothing beside a static body
// expects: Likely mistake: beside a static body nothing is done
// change: lambda *= ratio; ==> if (body1.is_static() || body2.is_static()) return; lambda *= ratio;

// ---- wrong: nothing in equal steps
// expects: change of v1 (equal steps)
// expects: Likely mistake: nothing is applied where the step has not changed
// change: lambda ==> if (ratio == 1) return; lambda

// ---- wrong: nothing of the last step kept
// expects: Likely mistake: lambda begins at zero where the step has changed
// change: lambda *= ratio; ==> if (ratio != 1) { lambda = vec3(0); return; }

// ---- wrong: one minus the ratio
// expects: Likely mistake: 1 - ratio: the impulse of this step is the ratio times the last one
// change: ratio ==> 1 - ratio

// ---- wrong: only body 2
// expects: change of v1 (shorter step)
// expects: Likely mistake: only body 2 feels it
// change: apply_impulse(J, lambda, body1, body2); ==>
//         for (int i = 0; i < 3; ++i) { body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
//         body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2); }

// ---- wrong: only scaled
// expects: Likely mistake: nothing is applied: lambda is scaled
  lambda *= ratio;

// ---- wrong: only v
// expects: change of w1 (shorter step)
// expects: Likely mistake: only v changes: lambda turns the bodies, too
// change: apply_impulse(J, lambda, body1, body2); ==>
//         for (int i = 0; i < 3; ++i) { body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
//         body2.v += body2.inverse_mass * lambda[i] * J[i].v2; }

// ---- wrong: ratio forgotten
// expects: lambda kept (on paper).y
// expects: Likely mistake: the ratio is forgotten
  apply_impulse(J, lambda, body1, body2);

// ---- wrong: ratio in an int
// expects: Likely mistake: the ratio is cut to a whole number
// change: ratio ==> real(int(ratio))

// ---- wrong: rows take each other's place
// expects: Likely mistake: each row takes the place of the one before: += and not =
// change: apply_impulse(J, lambda, body1, body2); ==>
//         for (int i = 0; i < 3; ++i) { body1.v = body1.inverse_mass * lambda[i] * J[i].v1; body1.w
//         = inverse_inertia(body1) * (lambda[i] * J[i].w1); body2.v = body2.inverse_mass *
//         lambda[i] * J[i].v2; body2.w = inverse_inertia(body2) * (lambda[i] * J[i].w2); }

// ---- wrong: safe at the bound
// region: 2
// expects: rho 0.5 iterations 1 beta 1
// expects: Likely mistake: at the bound nothing dies away
  return std::pow(rho, real(iterations)) * (1 + beta) <= 1;

// ---- wrong: safe beta in an int
// region: 2
// expects: Likely mistake: beta is cut to a whole number: an int has no fraction
  const int share = beta;
  return std::pow(rho, real(iterations)) * (1 + share) < 1;

// ---- wrong: safe by a sum
// region: 2
// expects: Likely mistake: rho^k + beta < 1, that is rho^k < 1 - beta
// change: * (1 + beta) ==> + beta

// ---- wrong: safe by the rest
// region: 2
// expects: Likely mistake: 1 - rho to the power k: rho itself is what an iteration leaves
// change: pow(rho ==> pow(1 - rho

// ---- wrong: safe one forgotten
// region: 2
// expects: rho 0.975528 iterations 4 beta 0.15
// expects: Likely mistake: 1 is forgotten
  return std::pow(rho, real(iterations)) < 1 / beta;

// ---- wrong: safe one minus beta
// region: 2
// expects: Likely mistake: the sign of beta
  return std::pow(rho, real(iterations)) * (1 - beta) < 1;

// ---- wrong: safe one iteration less
// region: 2
// expects: Likely mistake: one iteration less: k iterations leave rho to the power k
  real left = 1;
  for (int iteration = 1; iteration < iterations; ++iteration) left *= rho;
  return left * (1 + beta) < 1;

// ---- wrong: safe other side
// region: 2
// expects: Likely mistake: the sign of beta, or 1 + beta stands on the other side
  return std::pow(rho, real(iterations)) < 1 + beta;

// ---- wrong: safe power of both
// region: 2
// expects: Or 1 + beta has the power k, too: only rho has it
  return std::pow(rho * (1 + beta), real(iterations)) < 1;

// ---- wrong: safe rho in an int
// region: 2
// expects: Likely mistake: beta does not count: it is forgotten, or rho is cut to 0 by an int
  const int share = rho;
  return std::pow(share, iterations) * (1 + beta) < 1;

// ---- wrong: safe rho times iterations
// region: 2
// expects: Likely mistake: rho times k
  return rho * real(iterations) * (1 + beta) < 1;

// ---- wrong: safe iterations forgotten
// region: 2
// expects: rho 0.975528 iterations 6 beta 0.15
// expects: Likely mistake: the iterations are forgotten
  return rho * (1 + beta) < 1;

// ---- wrong: safe with a reserve
// region: 2
// expects: Likely mistake: a bound below 1: rho^k (1 + beta) is compared with 1 itself
// change: < 1 ==> < real(0.9)

// ---- wrong: scaled only where applied
// expects: Likely mistake: the scaled impulse is applied and the old one is kept
  apply_impulse(J, ratio * lambda, body1, body2);

// ---- wrong: set to zero
// expects: lambda kept (on paper).y
// expects: Likely mistake: lambda is set to zero: it must hold what has been applied
  apply_impulse(J, ratio * lambda, body1, body2);
  lambda = vec3(0);

// ---- wrong: without inertia
// expects: Likely mistake: the inverse inertia is missing in w1 and w2
// change: apply_impulse(J, lambda, body1, body2); ==>
//         for (int i = 0; i < 3; ++i) { body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
//         body1.w += lambda[i] * J[i].w1; body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
//         body2.w += lambda[i] * J[i].w2; }

// ---- right: applied row by row
// M^-1 J^T lambda row by row.
  lambda = ratio * lambda;
  for (int i = 0; i < 3; ++i) {
    body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
    body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1);
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
    body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2);
  }

// ---- right: safe by logarithms
// region: 2
  return rho <= 0 || real(iterations) * std::log(rho) + std::log1p(beta) < 0;

// ---- right: safe in a loop
// region: 2
// What k iterations leave, iteration by iteration.
  real left = 1;
  for (int iteration = 0; iteration < iterations; ++iteration) left *= rho;
  return left < 1 / (1 + beta);

// ---- right: safe with its parts
// region: 2
// The product written out: what is left, and what beta adds to it.
  const real left = std::pow(rho, real(iterations));
  return !(left + beta * left >= 1);

// ---- right: summed up first
// The push and the turn of all rows, then the bodies.
  lambda = lambda * ratio;
  vec3 push1(0), turn1(0), push2(0), turn2(0);
  for (int i = 0; i < 3; ++i) {
    push1 += J[i].v1 * lambda[i];
    turn1 += J[i].w1 * lambda[i];
    push2 += J[i].v2 * lambda[i];
    turn2 += J[i].w2 * lambda[i];
  }
  body1.v += push1 * body1.inverse_mass;
  body1.w += inverse_inertia(body1) * turn1;
  body2.v += push2 * body2.inverse_mass;
  body2.w += inverse_inertia(body2) * turn2;

// ---- wrong units: without inverse mass
// expects: Units: in the warm start, adding kg m/s to m/s
// change: apply_impulse(J, lambda, body1, body2); ==>
//         for (int i = 0; i < 3; ++i) { body1.v += lambda[i] * J[i].v1; body2.v += lambda[i] *
//         J[i].v2; }
