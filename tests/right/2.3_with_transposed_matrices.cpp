// region: 2
// J^T lambda with J^T as a matrix: its columns are the rows of J.
  const mat3 v1(J[0].v1, J[1].v1, J[2].v1), w1(J[0].w1, J[1].w1, J[2].w1);
  const mat3 v2(J[0].v2, J[1].v2, J[2].v2), w2(J[0].w2, J[1].w2, J[2].w2);
  body1.v += body1.inverse_mass * (v1 * lambda);
  body1.w += inverse_inertia(body1) * (w1 * lambda);
  body2.v += body2.inverse_mass * (v2 * lambda);
  body2.w += inverse_inertia(body2) * (w2 * lambda);
