// Known answers of exercise 6.2, each put in the place of the solution's.

// ---- wrong: applied before it is scaled
// expects: change of v2 (on paper).y
// expects: Likely mistake: the old impulse is applied and the scaled one is kept
  apply_impulse(J, lambda, body1, body2);
  lambda *= ratio;

// ---- wrong: divided by the ratio
// expects: Likely mistake: divided by the ratio
  lambda /= ratio;
  apply_impulse(J, lambda, body1, body2);

// ---- wrong: nothing in equal steps
// expects: change of v1 (equal steps)
// expects: Likely mistake: nothing is applied where the step has not changed
  if (ratio == 1) return;
  lambda *= ratio;
  apply_impulse(J, lambda, body1, body2);

// ---- wrong: only body 2
// expects: change of v1 (shorter step)
// expects: Likely mistake: only body 2 feels it
  lambda *= ratio;
  for (int i = 0; i < 3; ++i) {
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
    body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2);
  }

// ---- wrong: only scaled
// expects: Likely mistake: nothing is applied: lambda is scaled
  lambda *= ratio;

// ---- wrong: only v
// expects: change of w1 (shorter step)
// expects: Likely mistake: only v changes: lambda turns the bodies, too
  lambda *= ratio;
  for (int i = 0; i < 3; ++i) {
    body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
  }

// ---- wrong: ratio forgotten
// expects: lambda kept (on paper).y
// expects: Likely mistake: the ratio is forgotten
  apply_impulse(J, lambda, body1, body2);

// ---- wrong: safe at the bound
// region: 2
// expects: rho 0.5 sweeps 1 beta 1
// expects: Likely mistake: at the bound nothing dies away
  return std::pow(rho, real(sweeps)) * (1 + beta) <= 1;

// ---- wrong: safe one forgotten
// region: 2
// expects: rho 0.975528 sweeps 4 beta 0.15
// expects: Likely mistake: 1 is forgotten
  return std::pow(rho, real(sweeps)) < 1 / beta;

// ---- wrong: safe one minus beta
// region: 2
// expects: Likely mistake: the sign of beta
  return std::pow(rho, real(sweeps)) * (1 - beta) < 1;

// ---- wrong: safe other side
// region: 2
// expects: Likely mistake: the sign of beta, or 1 + beta stands on the other side
  return std::pow(rho, real(sweeps)) < 1 + beta;

// ---- wrong: safe power of both
// region: 2
// expects: Or 1 + beta has the power k, too: only rho has it
  return std::pow(rho * (1 + beta), real(sweeps)) < 1;

// ---- wrong: safe rho times sweeps
// region: 2
// expects: Likely mistake: rho times k
  return rho * real(sweeps) * (1 + beta) < 1;

// ---- wrong: safe sweeps forgotten
// region: 2
// expects: rho 0.975528 sweeps 6 beta 0.15
// expects: Likely mistake: the sweeps are forgotten
  return rho * (1 + beta) < 1;

// ---- wrong: scaled only where applied
// expects: Likely mistake: the scaled impulse is applied and the old one is kept
  apply_impulse(J, ratio * lambda, body1, body2);

// ---- wrong: set to zero
// expects: lambda kept (on paper).y
// expects: Likely mistake: lambda is set to zero: it must hold what has been applied
  apply_impulse(J, ratio * lambda, body1, body2);
  lambda = vec3(0);

// ---- right: applied row by row
// M^-1 J^T lambda row by row.
  lambda = ratio * lambda;
  for (int i = 0; i < 3; ++i) {
    body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
    body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1);
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
    body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2);
  }

// ---- right: safe in a loop
// region: 2
// What k sweeps leave, sweep by sweep.
  real left = 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) left *= rho;
  return left < 1 / (1 + beta);

// ---- right: safe with its parts
// region: 2
// The product written out: what is left, and what beta adds to it.
  const real left = std::pow(rho, real(sweeps));
  return !(left + beta * left >= 1);

// ---- wrong units: without inverse mass
// expects: Units: in the warm start, adding kg m/s to m/s
  lambda *= ratio;
  for (int i = 0; i < 3; ++i) {
    body1.v += lambda[i] * J[i].v1;
    body2.v += lambda[i] * J[i].v2;
  }
