// R as a matrix, for the levers and for R I^-1 R^T.
  const mat3 R1 = glm::mat3_cast(body1.q), R2 = glm::mat3_cast(body2.q);
  out.r1 = triple(R1 * hinge.point.anchor1_local);
  out.r2 = triple(R2 * hinge.point.anchor2_local);
  mat3 I1(0), I2(0);
  for (int k = 0; k < 3; ++k) {
    I1[k][k] = body1.inverse_inertia_local[k];
    I2[k][k] = body2.inverse_inertia_local[k];
  }
  out.I1 = symmetric(R1 * I1 * transpose(R1));
  out.I2 = symmetric(R2 * I2 * transpose(R2));
  const vec3 a1 = R1 * hinge.axis.a1_local;
  const vec3 b = R2 * hinge.axis.b_local, c = R2 * hinge.axis.c_local;
  out.axis_row[0] = triple(cross(b, a1));
  out.axis_row[1] = triple(cross(c, a1));
  const vec3 u = body2.x + R2 * hinge.point.anchor2_local - body1.x -
                 R1 * hinge.point.anchor1_local;
  const real C[] = {u.x, u.y, u.z, dot(a1, b), dot(a1, c)};
  for (int i = 0; i < 5; ++i) out.bias[i] = hinge.beta * C[i] / h;
