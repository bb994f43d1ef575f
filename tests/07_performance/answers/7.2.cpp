// wrong drawn-cut: const ==> if (inverse_mass1 < real(1e-6)) inverse_mass1 = 0; const
// mistake "beside a static body K is zero: the other one moves": for (int j = 0; j < 3; ++j) ==> if
//         (inverse_mass1 == 0 || inverse_mass2 == 0) return K; for (int j = 0; j < 3; ++j)
// expects: Fails at 1 static and 2 static; holds at upright, turned, moved, broken
// wrong "a factor of 0.5 in the axis' 2x2, in every case": dot ==> real(0.5) * dot
// wrong "the two axis rows are exchanged for body 2 between the point and the axis; and I2 of the other axis row in the axis' 2x2":
//         w2 = hinge.I2 * row[j] ==> w2 = hinge.I2 * row[1 - j]
// wrong "an index outside": K[3 + i][3 + j] ==> K[4 + i][4 + j]
// wrong "I1 with r2: I2 belongs to it, between the point and the axis; and I1 in": w2 = hinge.I2
//         ==> w2 = hinge.I1
// wrong "the second column is missing: there are two axis rows, between the": < 2 ==> < 1
// expects: and its second column is missing, in the axis' 2x2
// mistake "the inverse masses replace the entries on the diagonal: += and not = in the point's
//         3x3": K[j][j] += ==> K[j][j] =
// wrong "none of the usual ones, but it is in the point's 3x3 alone": 2 ==> 1
// wrong never-set: K[j][j] += inverse_mass1 + inverse_mass2; ==> { real sum; sum += K[j][j] +
//         inverse_mass1 + inverse_mass2; K[j][j] = sum; }
// mistake "the turns of body {1|2} are missing in the point's 3x3": cross(hinge.I{1|2} ==> real(0)
//         * cross(hinge.I{1|2}
// mistake "only the inverse masses: the turns are missing in the point's 3x3": cross ==> real(0) *
//         cross ;; cross(hinge.I2 ==> real(0) * cross(hinge.I2
// mistake "the sign of the turns of body {1|2}: the terms of both bodies are added in the point's
//         3x3": cross(hinge.I{1|2} ==> -cross(hinge.I{1|2}
// mistake "the sign of the turns: skew(r) I^-1 skew(r) lacks a transpose in the point's 3x3": cross
//         ==> -cross ;; cross(hinge.I2 ==> -cross(hinge.I2
// mistake "r{2|1} with I{1|2}: r{1|2} belongs to it in the point's 3x3": r{1|2}, along),
//         hinge.r{1|2} ==> r{2|1}, along), hinge.r{2|1}
// mistake "the levers, or the inverse inertias, are exchanged: r1 belongs to I1 in the point's
//         3x3": r1, along), hinge.r1 ==> r2, along), hinge.r2 ;; I2 * cross(hinge.r2, along),
//         hinge.r2 ==> I2 * cross(hinge.r1, along), hinge.r1
// mistake "I{2|1} with r{1|2}: I{1|2} belongs to it in the point's 3x3": I{1|2} ==> I{2|1}
// mistake "r{2|1} as the outer lever of body {1|2}: r{1|2} stands on both sides in the point's
//         3x3": r{1|2}) ==> r{2|1})
// mistake "the outer levers are exchanged in the point's 3x3": r1) ==> r2) ;; r2, along), hinge.r2
//         ==> r2, along), hinge.r1
// mistake "r{2|1} as the inner lever of body {1|2}: r{1|2} stands on both sides in the point's
//         3x3": r{1|2} ==> r{2|1}
// mistake "the inner levers are exchanged in the point's 3x3": r1 ==> r2 ;; r2, along), hinge.r2
//         ==> r1, along), hinge.r2
// mistake "I{1|2} is missing in the point's 3x3": hinge.I{1|2} * cross ==> cross
// mistake "the inverse inertias are missing in the point's 3x3": hinge.I1 * cross ==> cross ;;
//         hinge.I2 * cross ==> cross
// mistake "the outer lever of body {1|2} is missing: (I (r x e)) x r in the point's 3x3":
//         cross(hinge.I{1|2} * cross(hinge.r{1|2}, along), hinge.r{1|2}) ==> hinge.I{1|2} *
//         cross(hinge.r{1|2}, along)
// mistake "the outer levers are missing: (I (r x e)) x r in the point's 3x3": cross(hinge.I1 *
//         cross(hinge.r1, along), hinge.r1) ==> hinge.I1 * cross(hinge.r1, along) ;; cross(hinge.I2
//         * cross(hinge.r2, along), hinge.r2) ==> hinge.I2 * cross(hinge.r2, along)
// mistake "the inner lever of body {1|2} is missing: (I (r x e)) x r in the point's 3x3":
//         cross(hinge.r{1|2}, along) ==> along
// mistake "the inner levers are missing: (I (r x e)) x r in the point's 3x3": cross(hinge.r1,
//         along) ==> along ;; cross(hinge.r2, along) ==> along
// mistake "I{1|2} is applied last: (I (r x e)) x r in the point's 3x3": cross(hinge.I{1|2} * cross
//         ==> hinge.I{1|2} * cross(cross
// mistake "the inverse inertias are applied last: (I (r x e)) x r in the point's 3x3":
//         cross(hinge.I1 * cross ==> hinge.I1 * cross(cross ;; cross(hinge.I2 * cross ==> hinge.I2
//         * cross(cross
// mistake "the inverse masses are missing on the diagonal in the point's 3x3": K[j][j] +=
//         inverse_mass1 + inverse_mass2; ==>
// mistake "the inverse masses are added to all nine entries: they stand on the diagonal in the
//         point's 3x3": K[j ==> for (int i = 0; i < 3; ++i) K[i
// mistake "the inverse masses are added to the first column: they stand on the diagonal in the
//         point's 3x3": K[j][j] += inverse_mass1 + inverse_mass2; ==> ;; j = 0; j < 2 ==> i = 0; i
//         < 3; ++i) K[i][0] += inverse_mass1 + inverse_mass2; for (int j = 0; j < 2
// mistake "the inverse masses are added to the first row: they stand on the diagonal in the point's
//         3x3": j][ ==> 0][
// mistake "the entries below the diagonal are missing: the 3x3 is symmetric, both halves are needed
//         in the point's 3x3": K[j][j] += inverse_mass1 + inverse_mass2; ==> K[j][j] +=
//         inverse_mass1 + inverse_mass2; for (int i = j + 1; i < 3; ++i) K[i][j] = 0;
// mistake "the inverse masses stand in two places of the diagonal: there are three in the point's
//         3x3": K[j ==> if (j < 2) K[j
// mistake "the inverse mass of body {1|2} is missing in the point's 3x3": K[j][j] += inverse_mass1
//         + inverse_mass2; ==> K[j][j] += inverse_mass{2|1};
// mistake "the inverse mass of body {1|2} is added twice in the place of both: they are added in
//         the point's 3x3": inverse_mass1 + inverse_mass2 ==> 2 * inverse_mass{1|2}
// mistake "the sign of the inverse mass of body 2: both are added in the point's 3x3": K[j][j] +=
//         inverse_mass1 + inverse_mass2; ==> K[j][j] += inverse_mass1 - inverse_mass2;
// mistake "the sign of the inverse mass of body 1: both are added in the point's 3x3": K[j][j] +=
//         inverse_mass1 + inverse_mass2; ==> K[j][j] += inverse_mass2 - inverse_mass1;
// mistake "the sign of the inverse masses: they are added in the point's 3x3": += ==> -=
// mistake "the product of the inverse masses: they are added in the point's 3x3": K[j][j] +=
//         inverse_mass1 + inverse_mass2; ==> K[j][j] += inverse_mass1 * inverse_mass2;
// mistake "the mean of the inverse masses: they are added in the point's 3x3": K[j][j] +=
//         inverse_mass1 + inverse_mass2; ==> K[j][j] += (inverse_mass1 + inverse_mass2) / 2;
// mistake "one over the sum of the masses: each mass is inverted first, then they are added in the
//         point's 3x3": K[j][j] += inverse_mass1 + inverse_mass2; ==> K[j][j] += 1 / (1 /
//         inverse_mass1 + 1 / inverse_mass2);
// mistake "the masses: the arguments are the inverse masses, the arguments are 1/m already, add
//         them in the point's 3x3": inverse_mass1 + ==> 1 / inverse_mass1 + 1 /
// mistake "one over the sum of the inverse masses: the arguments are 1/m already, add them in the
//         point's 3x3": inverse_mass1 + inverse_mass2 ==> 1 / (inverse_mass1 + inverse_mass2)
// mistake "the turns of row C.{x|y|z} are missing in the point's 3x3": gap.{x|y|z} ==> 0
// mistake "row C.{y|z|z} has the turns of row C.{x|x|y} once more in the point's 3x3":
//         K[{1|2|2}][j] = gap.{y|z|z} ==> K[{1|2|2}][j] = gap.{x|x|y}
// mistake "the last column is not written yet in the point's 3x3": 3 ==> 2
// mistake "only its diagonal is there in the point's 3x3": inverse_mass2 ==> inverse_mass2; for
//         (int i = 0; i < 3; ++i) if (i != j) K[i][j] = 0
// mistake "it is not written yet in the point's 3x3": K[j][j] += inverse_mass1 + inverse_mass2; ==>
//         for (int i = 0; i < 3; ++i) K[i][j] = 0;
// mistake "body {1|2} is missing in the part between the point and the axis": cross(hinge.r1, w1) +
//         cross(hinge.r2, w2) ==> cross(hinge.r{2|1}, w{2|1})
// mistake "these are two blocks, not one: nothing is between the point and the axis": K[0][3 + j] =
//         K[3 + j][0] = -gap.x; K[1][3 + j] = K[3 + j][1] = -gap.y; K[2][3 + j] = K[3 + j][2] =
//         -gap.z; ==>
// mistake "the sign of the part between the point and the axis": cross(hinge.r1, w1) +
//         cross(hinge.r2, w2) ==> -cross(hinge.r1, w1) - cross(hinge.r2, w2)
// mistake "the sign of body {1|2} between the point and the axis": cross(hinge.r1, w1) +
//         cross(hinge.r2, w2) ==> {cross(hinge.r2, w2) - cross(hinge.r1, w1)|cross(hinge.r1, w1) -
//         cross(hinge.r2, w2)}
// mistake "r{2|1} with I{1|2}: r{1|2} belongs to it, between the point and the axis":
//         cross(hinge.r{1|2}, w{1|2}) ==> cross(hinge.r{2|1}, w{1|2})
// mistake "the levers, or the inverse inertias, are exchanged between the point and the axis": r1,
//         w1 ==> r2, w1 ;; r2, w2 ==> r1, w2
// mistake "I{2|1} with r{1|2}: I{1|2} belongs to it, between the point and the axis":
//         cross(hinge.r{1|2}, w{1|2}) ==> cross(hinge.r{1|2}, w{2|1})
// mistake "I{1|2} is missing between the point and the axis": w{1|2}) ==> row[j])
// mistake "the inverse inertias are missing between the point and the axis": cross(hinge.r1, w1)
//         ==> cross(hinge.r1, row[j]) ;; cross(hinge.r2, w2) ==> cross(hinge.r2, row[j])
// mistake "the lever of body {1|2} is missing between the point and the axis": cross(hinge.r{1|2},
//         w{1|2}) ==> w{1|2}
// mistake "the levers are missing between the point and the axis": cross(hinge.r1, w1) ==> w1 ;;
//         cross(hinge.r2, w2) ==> w2
// mistake "first I{1|2}, then the lever: r x (I^-1 a), not I^-1 (r x a), between the point and the
//         axis": cross(hinge.r{1|2}, w{1|2}) ==> hinge.I{1|2} * cross(hinge.r{1|2}, row[j])
// mistake "first the inverse inertia, then the lever: r x (I^-1 a), not I^-1 (r x a), between the
//         point and the axis": cross(hinge.r1, w1) ==> hinge.I1 * cross(hinge.r1, row[j]) ;;
//         cross(hinge.r2, w2) ==> hinge.I2 * cross(hinge.r2, row[j])
// mistake "the first axis row twice for body {1|2} between the point and the axis":
//         cross(hinge.r{1|2}, w{1|2}) ==> cross(hinge.r{1|2}, hinge.I{1|2} * row[0])
// mistake "the first axis row twice between the point and the axis": w1) ==> hinge.I1 * row[0]) ;;
//         w2) ==> hinge.I2 * row[0])
// mistake "the second axis row twice for body {1|2} between the point and the axis":
//         cross(hinge.r{1|2}, w{1|2}) ==> cross(hinge.r{1|2}, hinge.I{1|2} * row[1])
// mistake "the second axis row twice between the point and the axis": w1) ==> hinge.I1 * row[1]) ;;
//         w2) ==> hinge.I2 * row[1])
// mistake "the two axis rows are exchanged for body {1|2} between the point and the axis":
//         cross(hinge.r{1|2}, w{1|2}) ==> cross(hinge.r{1|2}, hinge.I{1|2} * row[1 - j])
// mistake "the columns of the two axis rows are exchanged between the point and the axis": w1) ==>
//         hinge.I1 * row[1 - j]) ;; w2) ==> hinge.I2 * row[1 - j])
// mistake "the columns beside the point are not mirrored: they stand below it once more, as rows,
//         between the point and the axis": K[3 + j][0] = -gap.x; K[1][3 + j] = K[3 + j][1] =
//         -gap.y; K[2][3 + j] = K[3 + j][2 ==> -gap.x; K[1][3 + j] = -gap.y; K[2][3 + j
// mistake "the rows below the point are not mirrored: they stand beside it once more, as columns,
//         between the point and the axis": 0][3 + j] = K[3 + j][0] = -gap.x; K[1][3 + j] = K[3 +
//         j][1] = -gap.y; K[2][3 + j] = ==> 3 + j][0] = -gap.x; K[3 + j][1] = -gap.y;
// mistake "mirrored with the other sign: K is symmetric, between the point and the axis": K[0][3 +
//         j] = K[3 + j][0] = -gap.x; K[1][3 + j] = K[3 + j][1] = -gap.y; K[2][3 + j] = K[3 + j][2]
//         = -gap.z; ==> K[3 + j][0] = gap.x; K[0][3 + j] = -gap.x; K[3 + j][1] = gap.y; K[1][3 + j]
//         = -gap.y; K[3 + j][2] = gap.z; K[2][3 + j] = -gap.z;
// mistake "mirrored with the other sign: K is symmetric. And the columns beside the point have a
//         minus, between the point and the axis": K[0][3 + j] = K[3 + j][0] = -gap.x; K[1][3 + j] =
//         K[3 + j][1] = -gap.y; K[2][3 + j] = K[3 + j][2] = -gap.z; ==> K[3 + j][0] = -gap.x;
//         K[0][3 + j] = gap.x; K[3 + j][1] = -gap.y; K[1][3 + j] = gap.y; K[3 + j][2] = -gap.z;
//         K[2][3 + j] = gap.z;
// mistake "the {second|first} column is missing: there are two axis rows, between the point and the
//         axis": -gap.x; K[1][3 + j] = K[3 + j][1] = -gap.y; K[2][3 + j] = K[3 + j][2] = -gap.z ==>
//         j == {0|1} ? -gap.x : real(0); K[1][3 + j] = K[3 + j][1] = j == {0|1} ? -gap.y : real(0);
//         K[2][3 + j] = K[3 + j][2] = j == {0|1} ? -gap.z : real(0)
// mistake "the levers, or the inertias, are added up first: each lever goes with its own, between
//         the point and the axis": r1, w1) + cross(hinge.r2, ==> r1 + hinge.r2, w1 +
// mistake "row C.{x|y|z} has the other sign between the point and the axis": = -gap.{x|y|z} ==> =
//         gap.{x|y|z}
// mistake "row C.{x|y|z} is missing between the point and the axis": K[{0|1|2}][3 + j] = K[3 +
//         j][{0|1|2}] = -gap.{x|y|z}; ==>
// mistake "body {1|2} is missing in the axis' 2x2": dot(row[i], w1 + w2) ==> dot(row[i], w{2|1})
// mistake "it is not written yet in the axis' 2x2": for (int i = 0; i < 2; ++i) K[3 + i][3 + j] =
//         dot(row[i], w1 + w2); ==>
// mistake "the sign of body {1|2}: the terms of both bodies are added in the axis' 2x2":
//         dot(row[i], w1 + w2) ==> dot(row[i], w{2|1} - w{1|2})
// mistake "the sign in the axis' 2x2": dot(row[i], w1 + w2) ==> -dot(row[i], w1 + w2)
// mistake "I{2|1} in the place of I{1|2} in the axis' 2x2": w1 + w2 ==> w{2|1} + w{2|1}
// mistake "I{1|2} is missing in the axis' 2x2": w1 + w2 ==> w{2|1} + row[j]
// mistake "the inverse inertias are missing in the axis' 2x2": dot(row[i], w1 + w2) ==> 2 *
//         dot(row[i], row[j])
// mistake "the inverse inertias are missing, and so is one of the bodies in the axis' 2x2":
//         dot(row[i], w1 + w2) ==> dot(row[i], row[j])
// mistake "I{1|2} of the other axis row in the axis' 2x2": dot(row[i], w1 + w2) ==> dot(row[i],
//         hinge.I{1|2} * row[1 - j] + w{2|1})
// mistake "I of the other axis row in the axis' 2x2": dot(row[i], w1 + w2) ==> dot(row[i], hinge.I1
//         * row[1 - j] + hinge.I2 * row[1 - j])
// mistake "I of the {first|second} axis row in both columns in the axis' 2x2": dot(row[i], w1 + w2)
//         ==> dot(row[i], hinge.I1 * row[{0|1}] + hinge.I2 * row[{0|1}])
// mistake "body {1|2} is added twice in the axis' 2x2": + w2 ==> + w2 + w{1|2}
// mistake "the inverse masses are added: these rows turn and do not push, in the axis' 2x2": + w2
//         ==> + w2) + (i == j ? inverse_mass1 + inverse_mass2 : real(0)
// mistake "the entries beside the diagonal are missing: its rows change each other's rates, in the
//         axis' 2x2": dot(row[i], w1 + w2) ==> i == j ? dot(row[i], w1 + w2) : real(0)
// mistake "it is filled on one side of its diagonal only: K is symmetric, in the axis' 2x2":
//         dot(row[i], w1 + w2) ==> i {<|>}= j ? dot(row[i], w1 + w2) : real(0)
// mistake "its {second|first} column is missing, in the axis' 2x2": dot(row[i], w1 + w2) ==> j ==
//         {0|1} ? dot(row[i], w1 + w2) : real(0)
// mistake "the dot product is taken with the same row twice: row i with column j, in the axis'
//         2x2": dot(row[i], w1 + w2) ==> dot(row[j], w1 + w2)
// mistake "the dot product is taken with the same row twice: row i with column j, in the axis'
//         2x2": dot(row[i], w1 + w2) ==> dot(row[i], hinge.I1 * row[i] + hinge.I2 * row[i])
// mistake "the {first|second} axis row stands on the left in both rows: row i, not row[{0|1}], in
//         the axis' 2x2": dot(row[i], w1 + w2) ==> dot(row[{0|1}], w1 + w2)
// mistake "the {first|second} axis row twice in the axis' 2x2": dot(row[i], w1 + w2) ==>
//         dot(row[{0|1}], hinge.I1 * row[{0|1}] + hinge.I2 * row[{0|1}])
// mistake "the axis rows are exchanged in the axis' 2x2": dot(row[i], w1 + w2) ==> dot(row[1 - i],
//         hinge.I1 * row[1 - j] + hinge.I2 * row[1 - j])
// mistake "body {1|2} is missing": + inverse_mass2 ==> ;; inverse_mass1 ==> inverse_mass{2|1} ;; w1
//         + w2 ==> w{2|1} ;; r1, w1) + cross(hinge.r2, w2 ==> r{2|1}, w{2|1} ;; I1 *
//         cross(hinge.r1, along), hinge.r1) + cross(hinge.I2 * cross(hinge.r2, along), hinge.r2 ==>
//         I{2|1} * cross(hinge.r{2|1}, along), hinge.r{2|1}
// mistake "the second row takes the first axis row again": row[j] ==> row[0] ;; row[j] ==> row[0]
//         ;; row[i] ==> row[0]
// mistake "I{1|2} is taken for both bodies": I{2|1} ==> I{1|2} ;; I{2|1} ==> I{1|2}
// mistake "r{1|2} is taken for both bodies": r2, along), hinge.r2 ==> r{1|2}, along), hinge.r{1|2}
//         ;; r1, along), hinge.r1 ==> r{1|2}, along), hinge.r{1|2} ;; r1, w1) + cross(hinge.r2, ==>
//         r{1|2}, w1 +
// mistake "the levers are missing": cross(hinge.I1 * cross(hinge.r1, along), hinge.r1) +
//         cross(hinge.I2 * cross(hinge.r2, along), hinge.r2) ==> real(0) * along ;; -gap.x ==> 0 ;;
//         -gap.y ==> 0 ;; -gap.z ==> 0
// mistake "the inverse inertias are missing: I1 and I2": hinge.I1 * ==> ;; hinge.I2 * ==> ;;
//         hinge.I1 * ==> ;; hinge.I2 * ==>
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
// mistake "the columns beside the point are not mirrored: they stand below it once more, as rows,
//         between the point and the axis": K[3 + j][i] = - ==> -
// expects: K[a1.c, C.x]
// mistake "the sign of the part between the point and the axis": -dot ==> dot
// expects: K[C.x, a1.c]
// mistake "the inverse of K: compute K itself, the loop inverts it": at); } ==> at); }
//         invert_symmetric(K[0].data(), 5);
// mistake "the levers, or the inverse inertias, are exchanged: r1 and I1 belong to body 1": r2, w2
//         ==> r1, w2 ;; r1, w1 ==> r2, w1 ;; r2 ==> r1 ;; r2 ==> r1 ;; r1 ==> r2 ;; r1 ==> r2
// wrong "the sign of the turns: skew(r) I^-1 skew(r) lacks a transpose in the point's 3x3; and the sign of the part between the point and the axis":
//         -dot ==> dot ;; dot ==> -dot
// wrong units "the part of K between point and axis is in 1/(kg m^2) and should be in 1/(kg m)":
//         cross(hinge.r1, w1) + cross(hinge.r2, w2) ==> w1 + w2
// wrong units "in K, adding 1/kg to 1/(kg m^2)": w2) ==> w2) + (i == j ? inverse_mass1 +
//         inverse_mass2 : real(0))
// wrong units "in K, adding 1/(kg m) to 1/kg": , hinge.r2 ==> , unit[j]
