// region: 2
// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
  for (int i = 0; i < 3; ++i) {
    body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
    body1.w += body1.inverse_inertia_local * (lambda[i] * J[i].w1);
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
    body2.w += body2.inverse_inertia_local * (lambda[i] * J[i].w2);
  }
