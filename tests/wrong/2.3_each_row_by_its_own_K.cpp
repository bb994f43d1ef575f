// expects: Likely mistake: each row divided by its own K: the rows of a block are solved together
  vec3 lambda;
  for (int i = 0; i < 3; ++i)
    lambda[i] = -(row_velocity(J[i], body1, body2) + bias[i]) / K[i][i];
  return lambda;
