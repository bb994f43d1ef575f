// wrong drawn-cut: const Triple<real> along ==> if (inverse_mass1 < real(1e-6)) inverse_mass1 = 0;
//         const Triple<real> along
// wrong "beside a static body K is zero: the other one moves": for (int j = 0; j < 3; ++j) ==> if
//         (inverse_mass1 == 0 || inverse_mass2 == 0) return K; for (int j = 0; j < 3; ++j)
// expects: Fails at 1 static and 2 static; holds at upright, turned, moved, broken
// wrong axis-dot-product-same: [i] ==> [j]
// wrong "a factor of 0.5 in the axis' 2x2, in every case": dot ==> real(0.5) * dot
// wrong added-up-first: cross(hinge.r1, w1) + cross(hinge.r2, w2) ==> cross(hinge.r1 + hinge.r2, w1
//         + w2)
// wrong "the two axis rows are exchanged for body 2 between the point and the axis; and I2 of the other axis row in the axis' 2x2":
//         w2 = hinge.I2 * row[j] ==> w2 = hinge.I2 * row[1 - j]
// wrong sign-one-line: = -gap.x ==> = gap.x
// wrong without-last-line: K[2][3 + j] = K[3 + j][2] = -gap.z; ==>
// wrong "an index outside": K[3 + i][3 + j] ==> K[4 + i][4 + j]
// wrong "I1 with r2: I2 belongs to it, between the point and the axis; and I1 in": w2 = hinge.I2
//         ==> w2 = hinge.I1
// wrong "the second column is missing: there are two axis rows, between the": < 2 ==> < 1
// expects: and its second column is missing, in the axis' 2x2
// wrong masses-first-row: K[j][j] += ==> K[0][j] +=
// wrong masses-place-turns: K[j][j] += ==> K[j][j] =
// wrong masses-taken-away: inverse_mass1 + inverse_mass2 ==> inverse_mass1 - inverse_mass2
// wrong "I1 is applied last: (I (r x e)) x r": cross(hinge.I1 * cross(hinge.r1, along), hinge.r1)
//         ==> hinge.I1 * cross(cross(hinge.r1, along), hinge.r1)
// wrong "r2 as the inner lever of body 1: r1 stands on both sides in the point's": r1 ==> r2
// wrong "the outer lever of body 1 is missing: (I (r x e)) x r": cross(hinge.I1 * cross(hinge.r1,
//         along), hinge.r1) ==> hinge.I1 * cross(hinge.r1, along)
// wrong point-row-twice: K[2][j] = gap.z ==> K[2][j] = gap.y
// wrong "none of the usual ones, but it is in the point's 3x3 alone": 2 ==> 1
// wrong never-set: K[j][j] += inverse_mass1 + inverse_mass2; ==> { real sum; sum += K[j][j] +
//         inverse_mass1 + inverse_mass2; K[j][j] = sum; }
// right J and its transpose:
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
// right blocks of matrices:
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
// right column by column:
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
// right columns where rows stand: K[0][j] = gap.x, K[1][j] = gap.y, K[2][j] = gap.z; ==> K[j][0] =
//         gap.x, K[j][1] = gap.y, K[j][2] = gap.z;
// right unit vectors on both sides:
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
// from right unit vectors on both sides
// wrong "body 1 is missing in the axis' 2x2": w1 + ==>
// wrong "the inverse masses are added: these rows turn and do not push, in the axis' 2x2": w2) ==>
//         w2) + (i == j ? inverse_mass1 + inverse_mass2 : real(0))
// wrong lever-first: at = ==> at = hinge.I1 * ;; r1, w1 ==> r1, row[j] ;; + cross ==> + hinge.I2 *
//         cross ;; r2, w2 ==> r2, row[j]
// wrong mirrored-minus: [i][3 + j] = K[3 + j][i] = -dot(unit[i], at) ==> [3 + j][i] = -(K[i][3 + j]
//         = -dot(unit[i], at))
// wrong "the columns beside the point are not mirrored": K[3 + j][i] = - ==> -
// expects: K[a1.c, C.x]
// wrong "body 1 is missing in the part between the point and the axis": r1, w1) + cross(hinge.r2
//         ==> r2
// wrong "the sign of the part between the point and the axis": -dot ==> dot
// expects: K[C.x, a1.c]
// wrong "the sign of body 1 between the point and the axis": r2, w2 ==> r1, w1 ;; (hinge.r1, w1) +
//         ==> (hinge.r2, w2) -
// wrong "the inverse inertias are missing between the point and the axis": r1, w1 ==> r1, row[j] ;;
//         r2, w2 ==> r2, row[j]
// wrong inverse-masses-all-nine: (i == j ? inverse_mass1 + inverse_mass2 : real(0)) ==>
//         inverse_mass1 + inverse_mass2
// wrong inverse-k-k-itself: at); } ==> at); } invert_symmetric(K[0].data(), 5);
// wrong inverted-once-more: inverse_mass1 + ==> 1 / inverse_mass1 + 1 /
// wrong levers-or-inverse-inertias: r2, w2 ==> r1, w2 ;; r1, w1 ==> r2, w1 ;; , hinge.r2 ==> ,
//         hinge.r1 ;; r2 ==> r1 ;; , hinge.r1 ==> , hinge.r2 ;; r1 ==> r2
// wrong one-over-whole-mass: inverse_mass1 + inverse_mass2 ==> 1 / (1 / inverse_mass1 + 1 /
//         inverse_mass2)
// wrong sum-that-thrown-away: + at2 ==> ;; + inverse_mass2 ==> ;; + w2 ==> ;; w1) + cross(hinge.r2,
//         w2 ==> w1
// wrong transposed-skew: dot ==> -dot
// wrong "these are two blocks, not one: nothing is between": for (int i = 0; i < 3; ++i) K[i][3 +
//         j] = K[3 + j][i] = -dot(unit[i], at); ==>
// wrong "the sign of the turns: skew(r) I^-1 skew(r) lacks a transpose in the point's 3x3; and the sign of the part between the point and the axis":
//         -dot ==> dot ;; dot ==> -dot
// wrong inverse-masses-are-missing: at2) + (i == j ? inverse_mass1 + inverse_mass2 : real(0) ==>
//         at2
// wrong units "the part of K between point and axis is in 1/(kg m^2) and should be in 1/(kg m)":
//         cross(hinge.r1, w1) + cross(hinge.r2, w2) ==> w1 + w2
// wrong units "in K, adding 1/kg to 1/(kg m^2)": w2) ==> w2) + (i == j ? inverse_mass1 +
//         inverse_mass2 : real(0))
// wrong units "in K, adding 1/(kg m) to 1/kg": , hinge.r2 ==> , unit[j]
