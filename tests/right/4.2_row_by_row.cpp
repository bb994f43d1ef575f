// region: 2
// The unit matrix, row by row.
  const vec3 e[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)};
  Jacobian<3> J;
  for (int i = 0; i < 3; ++i) J[i] = {vec3(0), -e[i], vec3(0), e[i]};
  return J;
