// region: 2
// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
  body1.v += body1.inverse_mass * lambda * J.v1;
  body1.w += body1.inverse_inertia_local * (lambda * J.w1);
  body2.v += body2.inverse_mass * lambda * J.v2;
  body2.w += body2.inverse_inertia_local * (lambda * J.w2);
