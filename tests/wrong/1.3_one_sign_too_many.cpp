// region: 2
// expects: Likely mistake: the sign: velocities grow by +M^-1 J^T lambda
  body1.v -= body1.inverse_mass * lambda * J.v1;  // the minus of body 1 is in J already
  body1.w -= inverse_inertia(body1) * (lambda * J.w1);
  body2.v += body2.inverse_mass * lambda * J.v2;
  body2.w += inverse_inertia(body2) * (lambda * J.w2);
