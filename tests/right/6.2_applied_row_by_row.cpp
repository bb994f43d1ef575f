// M^-1 J^T lambda row by row.
  lambda = ratio * lambda;
  for (int i = 0; i < 3; ++i) {
    body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
    body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1);
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
    body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2);
  }
