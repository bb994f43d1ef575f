// Known answers of exercise 7.2, each put in the place of the solution's.

// ---- wrong: all of it beside a static body
// expects: Fails at 1 static and 2 static; holds at upright, turned, moved, broken
// expects: Likely mistake: beside a static body K is zero: the other one moves
// change: for (int j = 0; j < 3; ++j) ==>
//         if (inverse_mass1 == 0 || inverse_mass2 == 0) return K; for (int j = 0; j < 3; ++j)

// ---- wrong: axis dot product with the same row
// expects: Likely mistake: the dot product is taken with the same row twice: row i with column j
// change: dot(row[i], w1 ==> dot(row[j], w1

// ---- wrong: axis halved
// expects: Likely mistake: a factor of 0.5 in the axis' 2x2, in every case
// change: dot(row[i], w1 + w2) ==> real(0.5) * dot(row[i], w1 + w2)

// ---- wrong: axis of body 2 only
// expects: Likely mistake: body 1 is missing in the axis' 2x2
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: axis with masses
// expects: Likely mistake: the inverse masses are added: these rows turn and do not push, in the
// expects: axis' 2x2
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2) +
                        (i == j ? inverse_mass1 + inverse_mass2 : real(0));
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: cross added up first
// expects: Likely mistake: the levers, or the inertias, are added up first: each lever goes with
// change: cross(hinge.r1, w1) + cross(hinge.r2, w2) ==>
//         cross(hinge.r1 + hinge.r2, w1 + w2)

// ---- wrong: cross and axis with the other row
// expects: Likely mistake: the two axis rows are exchanged for body 2 between the point and the
// expects: axis; and I2 of the other axis row in the axis' 2x2
// change: w2 = hinge.I2 * row[j] ==> w2 = hinge.I2 * row[1 - j]

// ---- wrong: cross lever first
// expects: Likely mistake: first the inverse inertia, then the lever: r x (I^-1 a)
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = hinge.I1 * cross(hinge.r1, row[j]) + hinge.I2 * cross(hinge.r2, row[j]);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: cross mirrored with a minus
// expects: Likely mistake: mirrored with the other sign: K is symmetric
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[3 + j][i] = -(K[i][3 + j] = -dot(unit[i], at));
  }

// ---- wrong: cross not mirrored
// expects: K[a1.c, C.x]
// expects: Likely mistake: the columns beside the point are not mirrored
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = -dot(unit[i], at);
  }

// ---- wrong: cross of body 2 only
// expects: Likely mistake: body 1 is missing in what stands between the point and the axis
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: cross sign
// expects: K[C.x, a1.c]
// expects: Likely mistake: the sign of what stands between the point and the axis
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = dot(unit[i], at);
  }

// ---- wrong: cross sign of one line
// expects: in K[C.x, a1.b], K[C.x, a1.c], K[a1.b, C.x] and K[a1.c, C.x] alone: the sign
// change: = -gap.x ==> = gap.x

// ---- wrong: cross with body 1 taken away
// expects: Likely mistake: the sign of body 1 between the point and the axis
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r2, w2) - cross(hinge.r1, w1);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: cross without inertia
// expects: Likely mistake: the inverse inertias are missing between the point and the axis
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, row[j]) + cross(hinge.r2, row[j]);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: cross without its last line
// expects: Likely mistake: in K[C.z, a1.b], K[C.z, a1.c], K[a1.b, C.z] and K[a1.c, C.z] alone:
// change: K[2][3 + j] = K[3 + j][2] = -gap.z; ==>

// ---- wrong: index outside
// expects: an index outside
// change: K[3 + i][3 + j] ==> K[4 + i][4 + j]

// ---- wrong: inertia of body 1 with body 2
// expects: Likely mistake: I1 with r2: I2 belongs to it, between the point and the axis; and I1 in
// change: w2 = hinge.I2 ==> w2 = hinge.I1

// ---- wrong: inverse masses in all nine
// expects: Likely mistake: the inverse masses are added to all nine entries
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                inverse_mass1 + inverse_mass2;
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: inverse of K
// expects: Likely mistake: the inverse of K: K itself is wanted
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }
  invert_symmetric(K[0].data(), 5);

// ---- wrong: inverted once more
// expects: Likely mistake: the masses: you are given the inverse masses
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? 1 / inverse_mass1 + 1 / inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: last axis column
// expects: Likely mistake: the second column is missing: there are two axis rows, between the
// expects: and its second column is missing, in the axis' 2x2
// change: for (int j = 0; j < 2; ++j) ==> for (int j = 0; j < 1; ++j)

// ---- wrong: levers exchanged
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
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r2, w1) + cross(hinge.r1, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: masses in the first row
// expects: Likely mistake: the inverse masses are added to the first row
// change: K[j][j] += ==> K[0][j] +=

// ---- wrong: masses in the place of the turns
// expects: Likely mistake: the inverse masses take the place of what stands on the diagonal
// change: K[j][j] += ==> K[j][j] =

// ---- wrong: masses taken away
// expects: Likely mistake: the sign of the inverse mass of body 2: both are added
// change: inverse_mass1 + inverse_mass2 ==> inverse_mass1 - inverse_mass2

// ---- wrong: one over the sum of the masses
// expects: Likely mistake: one over the sum of the masses: each mass is inverted first
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? 1 / (1 / inverse_mass1 + 1 / inverse_mass2) : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: only body 1
// expects: Likely mistake: body 2 is missing
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1) +
                (i == j ? inverse_mass1 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1);
    const Triple<real> at = cross(hinge.r1, w1);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: point inertia last
// expects: Likely mistake: I1 is applied last: (I (r x e)) x r
// change: cross(hinge.I1 * cross(hinge.r1, along), hinge.r1) ==>
//         hinge.I1 * cross(cross(hinge.r1, along), hinge.r1)

// ---- wrong: point inner lever
// expects: Likely mistake: r2 as the inner lever of body 1: r1 stands on both sides in the point's
// change: cross(hinge.r1, along) ==> cross(hinge.r2, along)

// ---- wrong: point outer lever missing
// expects: Likely mistake: the outer lever of body 1 is missing: (I (r x e)) x r
// change: cross(hinge.I1 * cross(hinge.r1, along), hinge.r1) ==> hinge.I1 * cross(hinge.r1, along)

// ---- wrong: point row twice
// expects: Likely mistake: row C.z has the turns of row C.y once more
// change: K[2][j] = gap.z ==> K[2][j] = gap.y

// ---- wrong: transposed skew
// expects: Likely mistake: the sign of the turns: skew(r) I^-1 skew(r) lacks a transpose
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = -dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong: two blocks
// expects: Likely mistake: these are two blocks, not one: nothing stands between
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
  }

// ---- wrong: two mistakes
// expects: Likely mistake: the sign of the turns: skew(r) I^-1 skew(r) lacks a
// expects: transpose in the point's 3x3; and the sign of what stands between the point and the axis
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = -dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = dot(unit[i], at);
  }

// ---- wrong: unknown in the point
// expects: Likely mistake: none of the usual ones, but it is in the point's 3x3 alone
// change: {real(j == 0), real(j == 1), real(j == 2)} ==> {real(j == 0), real(j == 1), real(j == 1)}

// ---- wrong: value never set
// expects: Likely mistake: a value that was never set
// change: K[j][j] += inverse_mass1 + inverse_mass2; ==>
//         { real sum; sum += K[j][j] + inverse_mass1 + inverse_mass2; K[j][j] = sum; }

// ---- wrong: without the inverse masses
// expects: Likely mistake: the inverse masses are missing on the diagonal
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2);
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- right: J and its transpose
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

// ---- right: blocks of matrices
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

// ---- right: column by column
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

// ---- right: columns where rows stand
// What the point does to itself is symmetric: its columns may be its rows.
// change: K[0][j] = gap.x, K[1][j] = gap.y, K[2][j] = gap.z; ==>
//         K[j][0] = gap.x, K[j][1] = gap.y, K[j][2] = gap.z;

// ---- wrong units: cross without levers
// expects: Units: what is between point and axis in K is in 1/(kg m^2) and should be in 1/(kg m)
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = w1 + w2;
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong units: masses on the whole diagonal
// expects: Units: in K, adding 1/kg to 1/(kg m^2)
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), hinge.r2);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2) +
                        (i == j ? inverse_mass1 + inverse_mass2 : real(0));
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }

// ---- wrong units: one lever forgotten
// expects: Units: in K, adding 1/(kg m) to 1/kg
  const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Triple<real> at1 = cross(hinge.I1 * cross(hinge.r1, unit[j]), hinge.r1);
    const Triple<real> at2 = cross(hinge.I2 * cross(hinge.r2, unit[j]), unit[j]);
    for (int i = 0; i < 3; ++i)
      K[i][j] = dot(unit[i], at1 + at2) +
                (i == j ? inverse_mass1 + inverse_mass2 : real(0));
  }
  for (int j = 0; j < 2; ++j) {
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
    const Triple<real> at = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = -dot(unit[i], at);
  }
