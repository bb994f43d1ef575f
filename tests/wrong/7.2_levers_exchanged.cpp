// expects: Likely mistake: the levers, or the inverse inertias, are exchanged
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r2, unit[j]), hinge.r2);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r1, unit[j]), hinge.r1);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> turn1 = hinge.I1 * row[j], turn2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], turn1 + turn2);
    const Triple<real> at = cross(hinge.r2, turn1) + cross(hinge.r1, turn2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }
