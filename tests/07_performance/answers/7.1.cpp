// wrong added-what-stood-there (the axis): out.bias[3 + i] = ==> out.bias[3 + i] +=
// wrong axis-biases-exchanged: 3 + ==> 4 -
// wrong axis-bodies-exchanged: axis.jacobian(body1, body2) ==> axis.jacobian(body2, body1)
// wrong axis-row-twice: axis[i] ==> axis[0]
// wrong axis-sign-one-row: triple(axis[i].w2) ==> triple(i == 0 ? axis[i].w1 : axis[i].w2)
// wrong axis-wrong-body: for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(axis[i].w2) ==> const
//         vec3 a = to_world(body2, hinge.axis.a1_local); out.axis_row[0] =
//         triple(cross(to_world(body2, hinge.axis.b_local), a)) ;; out.I1 ==> out.axis_row[1] =
//         triple(cross(to_world(body2, hinge.axis.c_local), a)); out.I1
// wrong for-sixty-steps: hinge.beta / h ==> 60 * hinge.beta
// expects: holds at upright, turned and moved
// wrong in-body-axes: hinge.point.error(body1, body2) ==> to_local(body1, hinge.point.error(body1,
//         body2))
// wrong few-digits: const real rate ==> const float rate
// wrong of-exchanged-bodies: hinge.axis.error(body1, body2) ==> hinge.axis.error(body2, body1)
// wrong one-place-too-early: out.bias[3 + i] ==> out.bias[2 + i]
// wrong "an index outside": out.bias[3 + i] ==> out.bias[4 + i]
// wrong rate-int: const real rate ==> const int rate
// wrong "the size of the error: a bias has its sign (the point)": rate * gap[i] ==> std::abs(rate *
//         gap[i])
// wrong never-set: out.bias[i] = rate * gap[i] ==> { real sum; sum += rate * gap[i]; out.bias[i] =
//         sum; }
// wrong with-velocities: out ==> const vec3 slip = point_velocity(body2, to_world(body2,
//         hinge.point.anchor2_local)) - point_velocity(body1, to_world(body1,
//         hinge.point.anchor1_local)); out ;; [i]; ==> [i] + slip[i];
// wrong without-beta: hinge.beta ==> 1
// wrong "h is forgotten: beta C is a length or an angle": / h ==>
// expects: bias[0]
// wrong "I1 and I2: body-space: it must be turned into the world": out ==> const auto local =
//         [](const Body& body) { const vec3 i = body.inverse_inertia_local; return
//         Symmetric<real>{i.x, i.y, i.z, 0, 0, 0}; }; out ;; symmetric(inverse_inertia(body1));
//         out.I2 = symmetric(inverse_inertia(body2)) ==> local(body1); out.I2 = local(body2)
// expects: Fails at upright, turned, moved, broken, 1 static, 2 static and no levers.
// wrong "r1 and r2: not turned into the world": to_world(body1, hinge.point.anchor1_local) ==>
//         hinge.point.anchor1_local ;; to_world(body2, hinge.point.anchor2_local) ==>
//         hinge.point.anchor2_local
// expects: Fails at upright, turned, moved, broken, 1 static and 2 static; holds at no levers
// wrong "I2: not written yet": out.I2 = symmetric(inverse_inertia(body2)); ==>
// wrong "I1: the inertia itself, not its inverse": inverse_inertia(body1) ==>
//         inverse(inverse_inertia(body1))
// wrong "I2: the inertia of the other body": (body2) ==> (body1)
// expects: I2.xx
// wrong "I2: times the inverse mass: an inverse inertia has the mass in it": inverse_inertia(body2)
//         ==> body2.inverse_mass * inverse_inertia(body2)
// wrong "I1 and I2: row after row: the diagonal xx, yy, zz comes first": out ==> const auto six =
//         [](const mat3& m) { return Symmetric<real>{m[0][0], m[0][1], m[0][2], m[1][1], m[1][2],
//         m[2][2]}; }; out ;; symmetric ==> six ;; symmetric ==> six
// wrong inverse-k-filled: out ==> for (int i = 0; i < 5; ++i) out.inverse_K[out.place(i, i)] = 1;
//         out
// wrong "all of out is set to zero, or replaced: inverse_K stays": out ==> out = {}; out
// expects: inverse_K[0]
// wrong "r1: the lever of the other body; and r2: not written yet": out.r2 ==> out.r1
// wrong "r1 and r2: the lever of the other body": r2 ==> r1 ;; r1 ==> r2
// expects: Pose: pencil and paper.
// expects: r1.z
// wrong "the error itself: beta C / h (the point)": rate * gap[i] ==> gap[i]
// wrong "not written yet: bias[4]. All five errors are fed back": for (int i = 0; i < 2; ++i)
//         out.bias[3 + i] = rate * tilt[i] ==> out.bias[3] = rate * tilt[0]
// wrong "r2: turned with the other body": body2 ==> body1
// expects: r2.x
// wrong "r1 and r2: the place of the anchor: a lever begins at the centre": to_world ==>
//         world_point ;; to_world ==> world_point
// wrong "the sign: b x a1 and c x a1 are the blocks w2": w2 ==> w1
// expects: axis_row[0].z
// wrong "not written yet: bias[3], bias[4]": for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate *
//         tilt[i]; ==>
// right levers by matrices:
  // R as a matrix, for the levers and for R I^-1 R^T.
  const mat3 R1 = glm::mat3_cast(body1.q), R2 = glm::mat3_cast(body2.q);
  out.r1 = triple(R1 * hinge.point.anchor1_local);
  out.r2 = triple(R2 * hinge.point.anchor2_local);
  mat3 I1(0), I2(0);
  for (int k = 0; k < 3; ++k) {
    I1[k][k] = body1.inverse_inertia_local[k];
    I2[k][k] = body2.inverse_inertia_local[k];
  }
  out.I1 = symmetric(R1 * I1 * transpose(R1));
  out.I2 = symmetric(R2 * I2 * transpose(R2));
  const vec3 a1 = R1 * hinge.axis.a1_local;
  const vec3 b = R2 * hinge.axis.b_local, c = R2 * hinge.axis.c_local;
  out.axis_row[0] = triple(cross(b, a1));
  out.axis_row[1] = triple(cross(c, a1));
  const vec3 u = body2.x + R2 * hinge.point.anchor2_local - body1.x -
                 R1 * hinge.point.anchor1_local;
  const real C[] = {u.x, u.y, u.z, dot(a1, b), dot(a1, c)};
  for (int i = 0; i < 5; ++i) out.bias[i] = hinge.beta * C[i] / h;
// right made anew with its K:
  // Everything at once, and the old contents of inverse_K are put back.
  const HingeNumbers<real> before = out;
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  const vec3 u = hinge.point.error(body1, body2);
  const Vector<2> C = hinge.axis.error(body1, body2);
  const real share = hinge.beta / h;
  out = {triple(to_world(body1, hinge.point.anchor1_local)),
         triple(to_world(body2, hinge.point.anchor2_local)),
         {triple(axis[0].w2), triple(axis[1].w2)},
         symmetric(inverse_inertia(body1)),
         symmetric(inverse_inertia(body2)),
         {share * u.x, share * u.y, share * u.z, share * C[0], share * C[1]},
         {}};
  for (int n = 0; n < 15; ++n) out.inverse_K[n] = before.inverse_K[n];
// right rows of body 1 turned round:
  // The blocks w1 are the opposites of those that are wanted; the point's levers stand in its J.
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(-axis[i].w1);
  out.r1 = triple(world_point(body1, hinge.point.anchor1_local) - body1.x);
  out.r2 = triple(world_point(body2, hinge.point.anchor2_local) - body2.x);
  const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
  out.I1 = {I1[0].x, I1[1].y, I1[2].z, I1[0].y, I1[0].z, I1[1].z};
  out.I2 = {I2[0].x, I2[1].y, I2[2].z, I2[0].y, I2[0].z, I2[1].z};
  const vec3 gap = hinge.point.error(body1, body2) * hinge.beta / h;
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  out.bias[0] = gap.x;
  out.bias[1] = gap.y;
  out.bias[2] = gap.z;
  out.bias[3] = hinge.beta * tilt[0] / h;
  out.bias[4] = hinge.beta * tilt[1] / h;
// wrong units "a bias of the point is in m and should be in m/s: a time too many": / h ==>
// wrong units "in the hoisted numbers, adding m/s to m": gap[i] ==> (gap[i] + body2.v[i] - body1.v[i])
// wrong units "I2 is in kg m^2 and should be in 1/(kg m^2): inertia where its inverse":
//         inverse_inertia(body2) ==> inverse(inverse_inertia(body2))
