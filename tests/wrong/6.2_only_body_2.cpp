// expects: change of v1 (shorter step)
// expects: Likely mistake: only body 2 feels it
  lambda *= ratio;
  for (int i = 0; i < 3; ++i) {
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
    body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2);
  }
