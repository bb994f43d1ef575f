// expects: change of w1 (shorter step)
// expects: Likely mistake: only v changes: lambda turns the bodies, too
  lambda *= ratio;
  for (int i = 0; i < 3; ++i) {
    body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
  }
