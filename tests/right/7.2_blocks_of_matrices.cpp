// The three parts as 3x3 and 3x2 matrices.
  const auto vector = [](const Triple<real>& a) { return vec3(a.x, a.y, a.z); };
  const auto matrix = [](const Symmetric<real>& m) {
    return mat3(m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz);
  };
  const mat3 s1 = skew(vector(hinge.r1)), s2 = skew(vector(hinge.r2));
  const mat3 I1 = matrix(hinge.I1), I2 = matrix(hinge.I2);
  const mat3 point = mat3(inverse_mass1 + inverse_mass2) + s1 * I1 * transpose(s1) +
                     s2 * I2 * transpose(s2);
  const mat3 beside = -(s1 * I1 + s2 * I2);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) K[i][j] = point[j][i];
  for (int j = 0; j < 2; ++j) {
    const vec3 a = vector(row[j]), column = beside * a;
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = column[i];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(vector(row[i]), (I1 + I2) * a);
  }
