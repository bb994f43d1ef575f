// expects: Likely mistake: the axis is turned with the wrong body: a1 rides on body 1
  out.r1 = triple(to_world(body1, hinge.point.anchor1_local));
  out.r2 = triple(to_world(body2, hinge.point.anchor2_local));
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  const vec3 a = to_world(body2, hinge.axis.a1_local);
  out.axis_row[0] = triple(cross(to_world(body2, hinge.axis.b_local), a));
  out.axis_row[1] = triple(cross(to_world(body2, hinge.axis.c_local), a));
  out.I1 = symmetric(inverse_inertia(body1));
  out.I2 = symmetric(inverse_inertia(body2));
  const real rate = hinge.beta / h;
  const vec3 gap = hinge.point.error(body1, body2);
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  for (int i = 0; i < 3; ++i) out.bias[i] = rate * gap[i];
  for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i];
