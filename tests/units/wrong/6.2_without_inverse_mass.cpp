// expects: Units: in the warm start, adding kg m/s to m/s
  lambda *= ratio;
  for (int i = 0; i < 3; ++i) {
    body1.v += lambda[i] * J[i].v1;
    body2.v += lambda[i] * J[i].v2;
  }
