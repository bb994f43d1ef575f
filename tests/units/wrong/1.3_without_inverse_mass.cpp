// region: 2
// expects: Units: in V + M^-1 J^T lambda, adding kg m/s to m/s: the inverse mass is missing
  body1.v += lambda * J.v1;
  body1.w += inverse_inertia(body1) * (lambda * J.w1);
  body2.v += lambda * J.v2;
  body2.w += inverse_inertia(body2) * (lambda * J.w2);
