// What an impulse of 1 along each row does to the rates of all rows.
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, none{0, 0, 0};
  for (int j = 0; j < 5; ++j) {
    const Triple<real> push = j < 3 ? unit[j] : none, turn = j < 3 ? none : row[j - 3];
    const Triple<real> w1 = hinge.I1 * (cross(hinge.r1, push) + turn);
    const Triple<real> w2 = hinge.I2 * (cross(hinge.r2, push) + turn);
    const Triple<real> gap = (inverse_mass1 + inverse_mass2) * push + cross(w1, hinge.r1) +
                             cross(w2, hinge.r2);
    for (int i = 0; i < 3; ++i) K[i][j] = dot(unit[i], gap);
    for (int i = 0; i < 2; ++i) K[3 + i][j] = dot(row[i], w1 + w2);
  }
