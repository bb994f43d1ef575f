// J M^-1 J^T with all five rows written out.
  const auto vector = [](const Triple<real>& a) { return vec3(a.x, a.y, a.z); };
  const auto matrix = [](const Symmetric<real>& m) {
    return mat3(m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz);
  };
  Jacobian<5> J;
  const Jacobian<3> point = jacobian_from_blocks(mat3(-1), skew(vector(hinge.r1)), mat3(1),
                                                 -skew(vector(hinge.r2)));
  for (int i = 0; i < 3; ++i) J[i] = point[i];
  for (int i = 0; i < 2; ++i)
    J[3 + i] = {vec3(0), -vector(row[i]), vec3(0), vector(row[i])};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      K[i][j] = inverse_mass1 * dot(J[i].v1, J[j].v1) +
                dot(J[i].w1, matrix(hinge.I1) * J[j].w1) +
                inverse_mass2 * dot(J[i].v2, J[j].v2) + dot(J[i].w2, matrix(hinge.I2) * J[j].w2);
