// Known answers of exercise 7.1, each put in the place of the solution's.

// ---- wrong: added to what stood there
// expects: Likely mistake: added to what stood there: = and not += (the axis)
// change: out.bias[3 + i] = ==> out.bias[3 + i] +=

// ---- wrong: axis biases exchanged
// expects: Likely mistake: the two of the axis are exchanged
// change: 3 + ==> 4 -

// ---- wrong: axis bodies exchanged
// expects: Likely mistake: the bodies are exchanged: axis.jacobian(body1, body2)
// change: axis.jacobian(body1, body2) ==> axis.jacobian(body2, body1)

// ---- wrong: axis row twice
// expects: Likely mistake: the first row stands there twice
// change: axis[i] ==> axis[0]

// ---- wrong: axis sign of one row
// expects: Likely mistake: the sign of the first row: b x a1 is the block w2
// change: triple(axis[i].w2) ==> triple(i == 0 ? axis[i].w1 : axis[i].w2)

// ---- wrong: axis with the wrong body
// expects: Likely mistake: the axis is turned with the wrong body: a1 rides on body 1
// change: for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(axis[i].w2) ==>
//         const vec3 a = to_world(body2, hinge.axis.a1_local); out.axis_row[0] =
//         triple(cross(to_world(body2, hinge.axis.b_local), a))
// change: out.I1 ==>
//         out.axis_row[1] = triple(cross(to_world(body2, hinge.axis.c_local), a)); out.I1

// ---- wrong: bias for sixty steps
// expects: Likely mistake: 60 in the place of 1/h
// expects: holds at upright, turned and moved
// change: hinge.beta / h ==> 60 * hinge.beta

// ---- wrong: bias in body axes
// expects: Likely mistake: the gap in the axes of body 1: point.error is in world axes already
// change: hinge.point.error(body1, body2) ==> to_local(body1, hinge.point.error(body1, body2))

// ---- wrong: bias in float
// expects: Likely mistake: right to a few digits only: is there a float among the reals
// change: const real rate ==> const float rate

// ---- wrong: bias of exchanged bodies
// expects: Likely mistake: the bodies are exchanged: axis.error(body1, body2)
// change: hinge.axis.error(body1, body2) ==> hinge.axis.error(body2, body1)

// ---- wrong: bias one place too early
// expects: Likely mistake: the two of the axis begin one place too early: bias[3] and bias[4]
// change: out.bias[3 + i] ==> out.bias[2 + i]

// ---- wrong: bias outside
// expects: an index outside
// change: out.bias[3 + i] ==> out.bias[4 + i]

// ---- wrong: bias rate in an int
// expects: Likely mistake: beta / h is cut to a whole number: an int has no fraction
// change: const real rate ==> const int rate

// ---- wrong: bias size of the gap
// expects: Likely mistake: the size of the error: a bias has its sign (the point)
// change: rate * gap[i] ==> std::abs(rate * gap[i])

// ---- wrong: bias value never set
// expects: Likely mistake: a value that was never set
// change: out.bias[i] = rate * gap[i] ==> { real sum; sum += rate * gap[i]; out.bias[i] = sum; }

// ---- wrong: bias with velocities
// expects: Likely mistake: the velocities are mixed in
// expects: the numbers of a hinge, its bodies at rest and flying
// change: out ==>
//         const vec3 slip = point_velocity(body2, to_world(body2, hinge.point.anchor2_local)) -
//         point_velocity(body1, to_world(body1, hinge.point.anchor1_local)); out
// change: [i]; ==> [i] + slip[i];

// ---- wrong: bias without beta
// expects: Likely mistake: beta is forgotten: this takes back all of the error
// change: hinge.beta ==> 1

// ---- wrong: bias without h
// expects: bias[0]
// expects: Likely mistake: h is forgotten: beta C is a way and an angle
// change: / h ==>

// ---- wrong: body space inertia
// expects: Fails at all poses.
// expects: Likely mistake: I1 and I2: body-space: it must be turned into the world
  const auto local = [](const Body& body) {
    const vec3 i = body.inverse_inertia_local;
    return Symmetric<real>{i.x, i.y, i.z, 0, 0, 0};
  };
  out.r1 = triple(to_world(body1, hinge.point.anchor1_local));
  out.r2 = triple(to_world(body2, hinge.point.anchor2_local));
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(axis[i].w2);
  out.I1 = local(body1);
  out.I2 = local(body2);
  const real rate = hinge.beta / h;
  const vec3 gap = hinge.point.error(body1, body2);
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  for (int i = 0; i < 3; ++i) out.bias[i] = rate * gap[i];
  for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i];

// ---- wrong: body space levers
// expects: Likely mistake: r1 and r2: not turned into the world
// expects: Fails at upright, turned, moved, broken, 1 static and 2 static; holds at no levers
  out.r1 = triple(hinge.point.anchor1_local);
  out.r2 = triple(hinge.point.anchor2_local);
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(axis[i].w2);
  out.I1 = symmetric(inverse_inertia(body1));
  out.I2 = symmetric(inverse_inertia(body2));
  const real rate = hinge.beta / h;
  const vec3 gap = hinge.point.error(body1, body2);
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  for (int i = 0; i < 3; ++i) out.bias[i] = rate * gap[i];
  for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i];

// ---- wrong: inertia forgotten
// expects: Likely mistake: I2: not written yet
// change: out.I2 = symmetric(inverse_inertia(body2)); ==>

// ---- wrong: inertia itself
// expects: Likely mistake: I1: the inertia itself, not its inverse
// change: inverse_inertia(body1) ==> inverse(inverse_inertia(body1))

// ---- wrong: inertia of body 1 twice
// expects: I2.xx
// expects: Likely mistake: I2: the inertia of the other body
// change: (body2) ==> (body1)

// ---- wrong: inertia of body 2 with its mass
// expects: Likely mistake: I2: times the inverse mass: an inverse inertia has the mass in it
// change: inverse_inertia(body2) ==> body2.inverse_mass * inverse_inertia(body2)

// ---- wrong: inertia row after row
// expects: Likely mistake: I1 and I2: row after row: the diagonal xx, yy, zz comes first
  const auto six = [](const mat3& m) {
    return Symmetric<real>{m[0][0], m[0][1], m[0][2], m[1][1], m[1][2], m[2][2]};
  };
  out.r1 = triple(to_world(body1, hinge.point.anchor1_local));
  out.r2 = triple(to_world(body2, hinge.point.anchor2_local));
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(axis[i].w2);
  out.I1 = six(inverse_inertia(body1));
  out.I2 = six(inverse_inertia(body2));
  const real rate = hinge.beta / h;
  const vec3 gap = hinge.point.error(body1, body2);
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  for (int i = 0; i < 3; ++i) out.bias[i] = rate * gap[i];
  for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i];

// ---- wrong: inverse K filled
// expects: Likely mistake: inverse_K stays as it is: K comes with exercise 7.2
// change: out ==> for (int i = 0; i < 5; ++i) out.inverse_K[out.place(i, i)] = 1; out

// ---- wrong: inverse K overwritten
// expects: inverse_K[0]
// expects: Likely mistake: all of out is set to zero, or made anew: inverse_K stays
// change: out ==> out = {}; out

// ---- wrong: lever written in the other place
// expects: Likely mistake: r1: the lever of the other body; and r2: not written yet
// change: out.r2 ==> out.r1

// ---- wrong: levers exchanged
// expects: Pose: pencil and paper.
// expects: r1.z
// expects: Likely mistake: r1 and r2: the lever of the other body
  out.r2 = triple(to_world(body1, hinge.point.anchor1_local));
  out.r1 = triple(to_world(body2, hinge.point.anchor2_local));
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(axis[i].w2);
  out.I1 = symmetric(inverse_inertia(body1));
  out.I2 = symmetric(inverse_inertia(body2));
  const real rate = hinge.beta / h;
  const vec3 gap = hinge.point.error(body1, body2);
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  for (int i = 0; i < 3; ++i) out.bias[i] = rate * gap[i];
  for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i];

// ---- wrong: no rate for the gap
// expects: Likely mistake: the error itself: beta C / h (the point)
// change: rate * gap[i] ==> gap[i]

// ---- wrong: one axis bias
// expects: Likely mistake: not written yet: bias[4]. All five errors are fed back
// change: for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i] ==>
//         out.bias[3] = rate * tilt[0]

// ---- wrong: one lever turned with the other body
// expects: r2.x
// expects: Likely mistake: r2: turned with the other body
// change: body2 ==> body1

// ---- wrong: points for levers
// expects: Likely mistake: r1 and r2: the place of the anchor: a lever begins at the centre
// change: to_world ==> world_point
// change: to_world ==> world_point

// ---- wrong: sign of the axis rows
// expects: axis_row[0].z
// expects: Likely mistake: the sign: b x a1 and c x a1 are the blocks w2
// change: w2 ==> w1

// ---- wrong: three biases
// expects: Likely mistake: not written yet: bias[3], bias[4]
// change: for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i]; ==>

// ---- right: levers by matrices
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

// ---- right: made anew with its K
// Everything at once, and what stood in inverse_K is put back.
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

// ---- right: rows of body 1 turned round
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

// ---- wrong units: bias without h
// expects: Units: a bias of the point is in m and should be in m/s: a time too many
// change: / h ==>

// ---- wrong units: gap and rate added
// expects: Units: in what is hoisted, adding m/s to m
// change: gap[i] ==> (gap[i] + body2.v[i] - body1.v[i])

// ---- wrong units: inertia for its inverse
// expects: Units: I2 is in kg m^2 and should be in 1/(kg m^2): inertia where its inverse
  out.r1 = triple(to_world(body1, hinge.point.anchor1_local));
  out.r2 = triple(to_world(body2, hinge.point.anchor2_local));
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(axis[i].w2);
  out.I1 = symmetric(inverse_inertia(body1));
  out.I2 = symmetric(inverse(inverse_inertia(body2)));
  const real rate = hinge.beta / h;
  const vec3 gap = hinge.point.error(body1, body2);
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  for (int i = 0; i < 3; ++i) out.bias[i] = rate * gap[i];
  for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i];
