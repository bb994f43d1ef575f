// wrong drawn-threshold: return ==> if (length(r1) < real(1e-4)) return -(skew(r2) *
//         inverse_inertia(body2)); return
// wrong k-point:
  return point.K(body1, body2);
// wrong "r2: the anchor of the other body": point.anchor2_local ==> point.anchor1_local
// wrong body-space-inertia: const ==> const auto local = [](const Body& body) { const vec3 i =
//         body.inverse_inertia_local; return mat3(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z); }; const ;; *
//         inverse_inertia ==> * local ;; * inverse_inertia ==> * local
// wrong "a factor of 2 in all of it, in every case": return - ==> return real(-2) *
// wrong "the inertia of body 2 is taken for body 1, too": (body1) ==> (body2)
// wrong last-column-never-filled: return ==> const mat3 all = ;; body2)); ==> body2)); mat3 X(0);
//         for (int column = 0; column < 2; ++column) X[column] = all[column]; return X;
// wrong "r1: body-space lever, it is not turned into the world": to_world(body1,
//         point.anchor1_local) ==> point.anchor1_local
// expects: holds at upright and 1 static
// wrong "r1: it ends at the anchor on the other body": to_world(body1, point.anchor1_local) ==>
//         world_point(body2, point.anchor2_local) - body1.x
// expects: Fails at broken
// wrong levers-added-up-first: (skew(r1) * ==> skew(r1 + r2) * ( ;; skew(r2) * ==>
// wrong inertias-exchanged: skew(r1) ==> skew(r2) ;; + skew(r2) ==> + skew(r1)
// wrong masses-place-inertias: inverse_inertia(body1) ==> body1.inverse_mass ;;
//         inverse_inertia(body2) ==> body2.inverse_mass
// wrong one-moment: inverse_inertia(body1) ==> body1.inverse_inertia_local.x ;;
//         inverse_inertia(body2) ==> body2.inverse_inertia_local.x
// wrong "beside a static body it is zero: the term of the other body stays": const vec3 r1 ==> if
//         (body1.is_static() || body2.is_static()) return mat3(0); const vec3 r1
// expects: Fails at 1 static and 2 static; holds at upright, turned, moved
// wrong sign-body-2-has: -(skew ==> skew ;; (body2)) ==> (body2)
// wrong "the sign of body 1's term: both terms have the minus":
// expects: Likely mistake: the sign of body 1's term: both terms have the minus, skew(r1)
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return skew(r1) * inverse_inertia(body1) - skew(r2) * inverse_inertia(body2);
// wrong transposed: -(skew(r1) * inverse_inertia(body1) + skew(r2) * inverse_inertia(body2)) ==>
//         inverse_inertia(body1) * skew(r1) + inverse_inertia(body2) * skew(r2)
// wrong "r1 and r2: turned the wrong way: to_world, not to_local": to_world ==> to_local ;;
//         to_world ==> to_local
// wrong "the sign of body 1's term: both terms have the minus": body2 ==> body1 ;; skew ==> -skew
// expects: and r2: turned with the other body: each anchor rides on its own
// wrong never-set: const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2,
//         point.anchor2_local); return -(skew(r1) * inverse_inertia(body1) + skew(r2) *
//         inverse_inertia(body2)) ==> mat3 X(0); for (int i = 0; i < 3; ++i) { real sum; sum +=
//         point.anchor1_local[i]; X[i][i] = sum; } return X
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
