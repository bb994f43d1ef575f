// K = L L^T: two triangular systems in the place of an inverse.
  vec3 e = bias;
  for (int i = 0; i < 3; ++i) e[i] += row_velocity(J[i], body1, body2);
  real L[3][3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) {
      real rest = K[j][i];
      for (int k = 0; k < j; ++k) rest -= L[i][k] * L[j][k];
      L[i][j] = i == j ? std::sqrt(rest) : rest / L[j][j];
    }
  vec3 y, x;
  for (int i = 0; i < 3; ++i) {
    real rest = -e[i];
    for (int k = 0; k < i; ++k) rest -= L[i][k] * y[k];
    y[i] = rest / L[i][i];
  }
  for (int i = 2; i >= 0; --i) {
    real rest = y[i];
    for (int k = i + 1; k < 3; ++k) rest -= L[k][i] * x[k];
    x[i] = rest / L[i][i];
  }
  return x;
