// Known answers of exercise 2.3, each put in the place of the solution's.

// ---- wrong: J without transpose
// region: 2
// expects: Likely mistake: the sign: velocities grow by +M^-1 J^T lambda
// expects: Likely mistake: J where J^T belongs: the sign of the turn
  vec3 push1, turn1, push2, turn2;
  for (int i = 0; i < 3; ++i) {
    push1[i] = dot(J[i].v1, lambda);
    turn1[i] = dot(J[i].w1, lambda);
    push2[i] = dot(J[i].v2, lambda);
    turn2[i] = dot(J[i].w2, lambda);
  }
  body1.v += body1.inverse_mass * push1;
  body1.w += inverse_inertia(body1) * turn1;
  body2.v += body2.inverse_mass * push2;
  body2.w += inverse_inertia(body2) * turn2;

// ---- wrong: body space inertia
// region: 2
// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
  for (int i = 0; i < 3; ++i) {
    body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
    body1.w += body1.inverse_inertia_local * (lambda[i] * J[i].w1);
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
    body2.w += body2.inverse_inertia_local * (lambda[i] * J[i].w2);
  }

// ---- wrong: each row by its own K
// expects: Likely mistake: each row divided by its own K: the rows of a block are solved together
  vec3 lambda;
  for (int i = 0; i < 3; ++i)
    lambda[i] = -(row_velocity(J[i], body1, body2) + bias[i]) / K[i][i];
  return lambda;

// ---- right: cholesky
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

// ---- right: with transposed matrices
// region: 2
// J^T lambda with J^T as a matrix: its columns are the rows of J.
  const mat3 v1(J[0].v1, J[1].v1, J[2].v1), w1(J[0].w1, J[1].w1, J[2].w1);
  const mat3 v2(J[0].v2, J[1].v2, J[2].v2), w2(J[0].w2, J[1].w2, J[2].w2);
  body1.v += body1.inverse_mass * (v1 * lambda);
  body1.w += inverse_inertia(body1) * (w1 * lambda);
  body2.v += body2.inverse_mass * (v2 * lambda);
  body2.w += inverse_inertia(body2) * (w2 * lambda);

// ---- wrong units: times K
// expects: Units: lambda is in m/(kg s) and should be in kg m/s: an inverse mass where a mass
// expects: belongs (K is one, divide by it)
  vec3 e = bias;
  for (int i = 0; i < 3; ++i) e[i] += row_velocity(J[i], body1, body2);
  return -K * e;
