// The rows of the point, each times the inverse inertia: J_t M^-1 J_r^T as it stands.
  const Jacobian<3> J = point.jacobian(body1, body2);
  const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
  mat3 X;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      X[column][row] = dot(J[row].w2, I2[column]) - dot(J[row].w1, I1[column]);
  return X;
