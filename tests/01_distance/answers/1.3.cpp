// Known answers of exercise 1.3, each put in the place of the solution's.

// ---- wrong: body space inertia
// region: 2
// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
  body1.v += body1.inverse_mass * lambda * J.v1;
  body1.w += body1.inverse_inertia_local * (lambda * J.w1);
  body2.v += body2.inverse_mass * lambda * J.v2;
  body2.w += body2.inverse_inertia_local * (lambda * J.w2);

// ---- wrong: one sign too many
// region: 2
// expects: Likely mistake: the sign: velocities grow by +M^-1 J^T lambda
  body1.v -= body1.inverse_mass * lambda * J.v1;  // the minus of body 1 is in J already
  body1.w -= inverse_inertia(body1) * (lambda * J.w1);
  body2.v += body2.inverse_mass * lambda * J.v2;
  body2.w += inverse_inertia(body2) * (lambda * J.w2);

// ---- wrong: only where there is an error
// expects: Likely mistake: nothing is done where the bias is 0. C = 0 does not mean that there is
// expects: nothing to solve
  if (K == 0 || std::abs(bias) < epsilon) return 0;  // the guard of the thesis' listing (E23)
  return -(row_velocity(J, body1, body2) + bias) / K;

// ---- wrong: without bias
// expects: Likely mistake: the bias is missing: the error is not fed back
  if (K == 0) return 0;
  return -row_velocity(J, body1, body2) / K;

// ---- right: K not positive
// K is never negative, so that K <= 0 asks the same as K == 0.
  return K <= 0 ? real(0) : -(row_velocity(J, body1, body2) + bias) / K;

// ---- wrong units: without inverse mass
// region: 2
// expects: Units: in V + M^-1 J^T lambda, adding kg m/s to m/s: the inverse mass is missing
  body1.v += lambda * J.v1;
  body1.w += inverse_inertia(body1) * (lambda * J.w1);
  body2.v += lambda * J.v2;
  body2.w += inverse_inertia(body2) * (lambda * J.w2);
