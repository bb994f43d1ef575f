// mistake "the sign: body 2 has -skew(r2) in the point and E in the lock: a minus": -(skew ==> skew
//         ;; (body2)) ==> (body2)
// mistake "transposed: the rows of X belong to the point and its columns to the lock, skew(r) I^-1
//         and not I^-1 skew(r)": -(skew(r1) * inverse_inertia(body1) + skew(r2) *
//         inverse_inertia(body2)) ==> inverse_inertia(body1) * skew(r1) + inverse_inertia(body2) *
//         skew(r2)
// mistake "transposed: the rows of X belong to the point and its columns to the lock, skew(r) I^-1
//         and not I^-1 skew(r). And the sign": -(skew(r1) * inverse_inertia(body1) + skew(r2) *
//         inverse_inertia(body2)) ==> -(inverse_inertia(body1) * skew(r1) + inverse_inertia(body2)
//         * skew(r2))
// mistake "the lever of one body with the inertia of the other": skew(r1) ==> skew(r2) ;; +
//         skew(r2) ==> + skew(r1)
// mistake "the levers, or the inertias, are added up first: each lever goes with its own inertia":
//         (skew(r1) * ==> skew(r1 + r2) * ( ;; skew(r2) * ==>
// mistake "a unit matrix is added: there is none in X": return - ==> return mat3(1) -
// mistake "beside a static body it is zero: the term of the other body stays": const vec3 r1 ==> if
//         (body1.is_static() || body2.is_static()) return mat3(0); const vec3 r1
// expects: Fails at 1 static and 2 static; holds at upright, turned, moved
// mistake "masses do not belong here: the lock turns, and pushes no centre": return - ==> return
//         mat3(body1.inverse_mass + body2.inverse_mass) -
// mistake "the lever is on one side only: this is the rotation's term in K of the point":
//         -(skew(r1) * inverse_inertia(body1) + skew(r2) * inverse_inertia(body2)) ==> -(skew(r1) *
//         inverse_inertia(body1) * skew(r1) + skew(r2) * inverse_inertia(body2) * skew(r2))
// mistake "the lever is on one side only: this is the rotation's term in K of the point. And the
//         sign": -(skew(r1) * inverse_inertia(body1) + skew(r2) * inverse_inertia(body2)) ==>
//         skew(r1) * inverse_inertia(body1) * skew(r1) + skew(r2) * inverse_inertia(body2) *
//         skew(r2)
// mistake "this is K of the point: X is the effect of the lock on the point":
  return point.K(body1, body2);
// mistake "the levers are missing: this is K of the lock": -(skew(r1) * inverse_inertia(body1) +
//         skew(r2) * inverse_inertia(body2)) ==> inverse_inertia(body1) + inverse_inertia(body2)
// mistake "the levers are missing: this is K of the lock, with a minus": -(skew(r1) *
//         inverse_inertia(body1) + skew(r2) * inverse_inertia(body2)) ==> -(inverse_inertia(body1)
//         + inverse_inertia(body2))
// mistake "X is zero: then a turn of the lock would not move the anchor": -(skew(r1) *
//         inverse_inertia(body1) + skew(r2) * inverse_inertia(body2)) ==> mat3(0)
// mistake "the sign of body 1's term: both terms have the minus, skew(r1) meets -E of the lock":
//         -(skew(r1) ==> (skew(r1) ;; + skew ==> - skew
// mistake "the sign of body 2's term: both terms have the minus": + skew ==> - skew
// mistake "the term of body 1 is missing": skew(r1) * inverse_inertia(body1) + ==>
// mistake "the term of body 2 is missing": + skew(r2) * inverse_inertia(body2) ==>
// mistake "the term of body 1 in another order: skew(r) I^-1 and not I^-1 skew(r)": skew(r1) *
//         inverse_inertia(body1) ==> inverse_inertia(body1) * skew(r1)
// mistake "the term of body 2 in another order: skew(r) I^-1 and not I^-1 skew(r)": skew(r2) *
//         inverse_inertia(body2) ==> inverse_inertia(body2) * skew(r2)
// mistake "the lever of body 2 is taken for body 1, too": skew(r1) ==> skew(r2)
// mistake "the lever of body 1 is taken for body 2, too": skew(r2) ==> skew(r1)
// mistake "the inertia of body 2 is taken for body 1, too": inertia(body1) ==> inertia(body2)
// mistake "the inertia of body 1 is taken for body 2, too": inertia(body2) ==> inertia(body1)
// mistake "r1 and r2: body-space lever, it is not turned into the world: to_world(body, anchor)":
//         to_world(body1, point.anchor1_local) ==> point.anchor1_local ;; to_world(body2,
//         point.anchor2_local) ==> point.anchor2_local
// mistake "r1: body-space lever, it is not turned into the world: to_world(body, anchor)":
//         to_world(body1, point.anchor1_local) ==> point.anchor1_local
// expects: holds at upright and 1 static
// mistake "r2: body-space lever, it is not turned into the world: to_world(body, anchor)":
//         to_world(body2, point.anchor2_local) ==> point.anchor2_local
// mistake "r1 and r2: turned the wrong way: to_world, not to_local": to_world(body1,
//         point.anchor1_local) ==> to_local(body1, point.anchor1_local) ;; to_world(body2,
//         point.anchor2_local) ==> to_local(body2, point.anchor2_local)
// mistake "r1: turned the wrong way: to_world, not to_local": to_world(body1, point.anchor1_local)
//         ==> to_local(body1, point.anchor1_local)
// mistake "r2: turned the wrong way: to_world, not to_local": to_world(body2, point.anchor2_local)
//         ==> to_local(body2, point.anchor2_local)
// mistake "r1 and r2: a point where a lever belongs: r runs from the body's centre to the anchor
//         (to_world, not world_point)": to_world(body1, point.anchor1_local) ==> world_point(body1,
//         point.anchor1_local) ;; to_world(body2, point.anchor2_local) ==> world_point(body2,
//         point.anchor2_local)
// mistake "r1: a point where a lever belongs: r runs from the body's centre to the anchor
//         (to_world, not world_point)": to_world(body1, point.anchor1_local) ==> world_point(body1,
//         point.anchor1_local)
// mistake "r2: a point where a lever belongs: r runs from the body's centre to the anchor
//         (to_world, not world_point)": to_world(body2, point.anchor2_local) ==> world_point(body2,
//         point.anchor2_local)
// mistake "r1 and r2: the anchor of the other body": to_world(body1, point.anchor1_local) ==>
//         to_world(body1, point.anchor2_local) ;; to_world(body2, point.anchor2_local) ==>
//         to_world(body2, point.anchor1_local)
// mistake "r1: the anchor of the other body": to_world(body1, point.anchor1_local) ==>
//         to_world(body1, point.anchor2_local)
// mistake "r2: the anchor of the other body": to_world(body2, point.anchor2_local) ==>
//         to_world(body2, point.anchor1_local)
// mistake "r1 and r2: turned with the other body: each anchor rides on its own": to_world(body1,
//         point.anchor1_local) ==> to_world(body2, point.anchor1_local) ;; to_world(body2,
//         point.anchor2_local) ==> to_world(body1, point.anchor2_local)
// mistake "r1: turned with the other body: each anchor rides on its own": to_world(body1,
//         point.anchor1_local) ==> to_world(body2, point.anchor1_local)
// mistake "r2: turned with the other body: each anchor rides on its own": to_world(body2,
//         point.anchor2_local) ==> to_world(body1, point.anchor2_local)
// mistake "r1 and r2: it ends at the anchor on the other body: that is the same point only while
//         the gap is zero": to_world(body1, point.anchor1_local) ==> world_point(body2,
//         point.anchor2_local) - body1.x ;; to_world(body2, point.anchor2_local) ==>
//         world_point(body1, point.anchor1_local) - body2.x
// mistake "r1: it ends at the anchor on the other body: that is the same point only while the gap
//         is zero": to_world(body1, point.anchor1_local) ==> world_point(body2,
//         point.anchor2_local) - body1.x
// expects: Fails at broken
// mistake "r2: it ends at the anchor on the other body: that is the same point only while the gap
//         is zero": to_world(body2, point.anchor2_local) ==> world_point(body1,
//         point.anchor1_local) - body2.x
// mistake "r1 and r2: the gap in the place of the lever: r runs from the body's centre to the
//         anchor": to_world(body1, point.anchor1_local) ==> point.error(body1, body2) ;;
//         to_world(body2, point.anchor2_local) ==> point.error(body1, body2)
// mistake "r1: the gap in the place of the lever: r runs from the body's centre to the anchor":
//         to_world(body1, point.anchor1_local) ==> point.error(body1, body2)
// mistake "r2: the gap in the place of the lever: r runs from the body's centre to the anchor":
//         to_world(body2, point.anchor2_local) ==> point.error(body1, body2)
// mistake "r1 and r2: from centre to centre: r runs from the body's centre to the anchor":
//         to_world(body1, point.anchor1_local) ==> body2.x - body1.x ;; to_world(body2,
//         point.anchor2_local) ==> body2.x - body1.x
// mistake "r1: from centre to centre: r runs from the body's centre to the anchor": to_world(body1,
//         point.anchor1_local) ==> body2.x - body1.x
// mistake "r2: from centre to centre: r runs from the body's centre to the anchor": to_world(body2,
//         point.anchor2_local) ==> body2.x - body1.x
// mistake "r1 and r2: made a unit vector: a lever keeps its length": const ==> const auto unit =
//         [](const vec3& a) { return a / glm::max(length(a), real(1e-9)); }; const ;;
//         to_world(body1, point.anchor1_local) ==> unit(to_world(body1, point.anchor1_local)) ;;
//         to_world(body2, point.anchor2_local) ==> unit(to_world(body2, point.anchor2_local))
// mistake "r1: made a unit vector: a lever keeps its length": const ==> const auto unit = [](const
//         vec3& a) { return a / glm::max(length(a), real(1e-9)); }; const ;; to_world(body1,
//         point.anchor1_local) ==> unit(to_world(body1, point.anchor1_local))
// mistake "r2: made a unit vector: a lever keeps its length": const ==> const auto unit = [](const
//         vec3& a) { return a / glm::max(length(a), real(1e-9)); }; const ;; to_world(body2,
//         point.anchor2_local) ==> unit(to_world(body2, point.anchor2_local))
// mistake "body-space inertia: take inverse_inertia(body) (both bodies)": const ==> const auto
//         local = [](const Body& body) { const vec3 i = body.inverse_inertia_local; return
//         mat3(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z); }; const ;; * inverse_inertia(body1) ==> *
//         local(body1) ;; * inverse_inertia(body2) ==> * local(body2)
// mistake "body-space inertia: take inverse_inertia(body) (body 1)": const ==> const auto local =
//         [](const Body& body) { const vec3 i = body.inverse_inertia_local; return mat3(i.x, 0, 0,
//         0, i.y, 0, 0, 0, i.z); }; const ;; * inverse_inertia(body1) ==> * local(body1)
// mistake "body-space inertia: take inverse_inertia(body) (body 2)": const ==> const auto local =
//         [](const Body& body) { const vec3 i = body.inverse_inertia_local; return mat3(i.x, 0, 0,
//         0, i.y, 0, 0, 0, i.z); }; const ;; * inverse_inertia(body2) ==> * local(body2)
// mistake "the inertia is turned the wrong way round: R I^-1 R^T, not R^T I^-1 R (both bodies)":
//         const ==> const auto back = [](Body body) { body.q = conjugate(body.q); return
//         inverse_inertia(body); }; const ;; * inverse_inertia(body1) ==> * back(body1) ;; *
//         inverse_inertia(body2) ==> * back(body2)
// mistake "the inertia is turned the wrong way round: R I^-1 R^T, not R^T I^-1 R (body 1)": const
//         ==> const auto back = [](Body body) { body.q = conjugate(body.q); return
//         inverse_inertia(body); }; const ;; * inverse_inertia(body1) ==> * back(body1)
// mistake "the inertia is turned the wrong way round: R I^-1 R^T, not R^T I^-1 R (body 2)": const
//         ==> const auto back = [](Body body) { body.q = conjugate(body.q); return
//         inverse_inertia(body); }; const ;; * inverse_inertia(body2) ==> * back(body2)
// mistake "inertia where inverse inertia belongs: inverse_inertia(body) is the inverse already
//         (both bodies)": const ==> const auto inertia = [](const Body& body) { return
//         body.is_static() ? mat3(0) : inverse(inverse_inertia(body)); }; const ;; *
//         inverse_inertia(body1) ==> * inertia(body1) ;; * inverse_inertia(body2) ==> *
//         inertia(body2)
// mistake "inertia where inverse inertia belongs: inverse_inertia(body) is the inverse already
//         (body 1)": const ==> const auto inertia = [](const Body& body) { return body.is_static()
//         ? mat3(0) : inverse(inverse_inertia(body)); }; const ;; * inverse_inertia(body1) ==> *
//         inertia(body1)
// mistake "inertia where inverse inertia belongs: inverse_inertia(body) is the inverse already
//         (body 2)": const ==> const auto inertia = [](const Body& body) { return body.is_static()
//         ? mat3(0) : inverse(inverse_inertia(body)); }; const ;; * inverse_inertia(body2) ==> *
//         inertia(body2)
// mistake "one moment stands for all three axes: that is right for a ball alone (both bodies)": *
//         inverse_inertia(body1) ==> * body1.inverse_inertia_local.x ;; * inverse_inertia(body2)
//         ==> * body2.inverse_inertia_local.x
// mistake "one moment stands for all three axes: that is right for a ball alone (body 1)": *
//         inverse_inertia(body1) ==> * body1.inverse_inertia_local.x
// mistake "one moment stands for all three axes: that is right for a ball alone (body 2)": *
//         inverse_inertia(body2) ==> * body2.inverse_inertia_local.x
// mistake "the inverse inertia is missing (both bodies)": * inverse_inertia(body1) ==> * mat3(1) ;;
//         * inverse_inertia(body2) ==> * mat3(1)
// mistake "the inverse inertia is missing (body 1)": * inverse_inertia(body1) ==> * mat3(1)
// mistake "the inverse inertia is missing (body 2)": * inverse_inertia(body2) ==> * mat3(1)
// mistake "the inverse mass in the place of the inverse inertia: the lock turns, and pushes no
//         centre (both bodies)": * inverse_inertia(body1) ==> * body1.inverse_mass ;; *
//         inverse_inertia(body2) ==> * body2.inverse_mass
// mistake "the inverse mass in the place of the inverse inertia: the lock turns, and pushes no
//         centre (body 1)": * inverse_inertia(body1) ==> * body1.inverse_mass
// mistake "the inverse mass in the place of the inverse inertia: the lock turns, and pushes no
//         centre (body 2)": * inverse_inertia(body2) ==> * body2.inverse_mass
// mistake "the sign of body 1's term: both terms have the minus, skew(r1) meets -E of the lock; and
//         r2: turned with the other body: each anchor rides on its own": body2 ==> body1 ;; skew
//         ==> -skew
// mistake "one moment stands for all three axes: that is right for a ball alone":
//         inverse_inertia(body1) ==> body1.inverse_inertia_local.x ;; inverse_inertia(body2) ==>
//         body2.inverse_inertia_local.x
// mistake "one moment stands for all three axes: that is right for a ball alone":
//         inverse_inertia(body1) ==> body1.inverse_inertia_local.y ;; inverse_inertia(body2) ==>
//         body2.inverse_inertia_local.y
// mistake "one moment stands for all three axes: that is right for a ball alone":
//         inverse_inertia(body1) ==> body1.inverse_inertia_local.z ;; inverse_inertia(body2) ==>
//         body2.inverse_inertia_local.z
// wrong drawn-threshold: return ==> if (length(r1) < real(1e-4)) return -(skew(r2) *
//         inverse_inertia(body2)); return
// wrong "a factor of 2 in all of it, in every case": return - ==> return real(-2) *
// wrong never-set: const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2,
//         point.anchor2_local); return -(skew(r1) * inverse_inertia(body1) + skew(r2) *
//         inverse_inertia(body2)) ==> mat3 X(0); for (int i = 0; i < 3; ++i) { real sum; sum +=
//         point.anchor1_local[i]; X[i][i] = sum; } return X
// mistake "the last column is never filled: that of a turn about z": return ==> const mat3 all = ;; body2)); ==> body2)); mat3 X(0);
//         for (int column = 0; column < 2; ++column) X[column] = all[column]; return X;
// right column by column:
  // What a turn about each axis does to the anchors.
  mat3 X(0);
  for (int column = 0; column < 3; ++column) {
    vec3 turn(0);
    turn[column] = 1;
    X[column] = cross(inverse_inertia(body1) * turn, to_world(body1, point.anchor1_local)) +
                cross(inverse_inertia(body2) * turn, to_world(body2, point.anchor2_local));
  }
  return X;
// right entry by entry:
  // The rows of the point, each times the inverse inertia: J_t M^-1 J_r^T as it stands.
  const Jacobian<3> J = point.jacobian(body1, body2);
  const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
  mat3 X;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      X[column][row] = dot(J[row].w2, I2[column]) - dot(J[row].w1, I1[column]);
  return X;
// right transposed twice: -(skew(r1) * inverse_inertia(body1) + skew(r2) * inverse_inertia(body2))
//         ==> transpose(inverse_inertia(body1) * skew(r1) + inverse_inertia(body2) * skew(r2))
// wrong units "X is in 1/kg and should be in 1/(kg m): a length too many":
  const mat3 s1 = skew(to_world(body1, point.anchor1_local));
  const mat3 s2 = skew(to_world(body2, point.anchor2_local));
  return s1 * inverse_inertia(body1) * s1 + s2 * inverse_inertia(body2) * s2;
